// SPDX-License-Identifier: MIT
// What the server says in English, in other languages. In English its own sentence is shown, and that is also what
// stands where a translation is missing.
import type { EventCode, StoppedCode } from './protocol/codes';
import type { Language } from './texts';

export type ServerTextKey =
  | `event.${EventCode}`
  | `event.${EventCode}.cause`
  | `event.${EventCode}.remedy`
  | `stopped.${StoppedCode}`;

const german: Partial<Record<ServerTextKey, string>> = {
  'event.reset': 'Der Roboter ist neu gestartet und wieder eingerichtet',
  'event.reset.cause':
    'Seine Spannung bricht ein, wenn die Motoren anlaufen, sein Watchdog hat ausgelöst, oder ein anderes Programm hat seinen Anschluss geöffnet',
  'event.reset.remedy': 'Frische Batterien, ein Kondensator an der Versorgung der Motoren; nur ein Programm je Anschluss',
  'event.link-ready': 'Der Roboter antwortet',
  'event.link-lost': 'Die Verbindung zum Roboter ist weg; seine Räder halten von selbst',
  'event.link-lost.cause': 'Kabel oder Funk, oder die Platine hat keinen Strom',
  'event.link-lost.remedy': 'Wieder einstecken: Die Fahrt geht von selbst weiter',
  'event.lifted': 'Der Roboter wurde hochgehoben: Er kann überall abgesetzt werden',
  'event.lifted.cause': 'Ein Rad hängt in der Luft, oder unter ihm ist kein Boden',
  'event.lifted.remedy': 'Setze ihn ab; er sucht seinen Ort',
  'event.bumped': 'Er hat etwas berührt, das jetzt in der Karte ist',
  'event.bumped.cause': 'Zu niedrig, zu dünn oder zu weich für das Sonar',
  'event.sonar-dead': 'Das Sonar antwortet nicht',
  'event.sonar-dead.cause': 'Es ist nicht angeschlossen, hat keine Spannung oder ist defekt',
  'event.sonar-dead.remedy': 'Prüfe seine vier Drähte und seine 5 V',
  'event.sonar-answers': 'Das Sonar antwortet wieder',
  'event.encoder-left-dirty': 'Der linke Encoder verliert Zählungen: Die Odometrie stimmt nicht',
  'event.encoder-left-dirty.cause': 'Schmutz auf seiner Scheibe, eine Scheibe mit Schlag, ein loser Draht',
  'event.encoder-left-dirty.remedy': 'Reinige ihn, stelle seinen Abstand ein, prüfe Drähte und Spannung',
  'event.encoder-right-dirty': 'Der rechte Encoder verliert Zählungen: Die Odometrie stimmt nicht',
  'event.encoder-right-dirty.cause': 'Schmutz auf seiner Scheibe, eine Scheibe mit Schlag, ein loser Draht',
  'event.encoder-right-dirty.remedy': 'Reinige ihn, stelle seinen Abstand ein, prüfe Drähte und Spannung',
  'event.maps-joined': 'Er hat seinen Ort in der früheren Karte gefunden; beide Karten sind wieder eine',
  'event.new-map': 'Was er hört, passt nicht zur Karte: Er beginnt eine neue',
  'event.new-map.cause': 'Er wurde weggetragen, oder ein Rad ist gerutscht',
  'event.new-map.remedy': 'Nichts zu tun: Die frühere Karte bleibt und wird verbunden, sobald er sie erkennt',
  'event.stop': 'STOPP wurde gedrückt',
  'event.driver-gone': 'Angehalten: Die Seite des Fahrers schweigt',
  'event.driver-gone.cause': 'Ihr Tab wurde geschlossen oder verdeckt, oder ihre Verbindung ist langsam oder weg',
  'event.driver-gone.remedy': 'Fahre weiter oder lass ihn erkunden',
  'event.no-way': 'Kein bekannter Boden führt dorthin',
  'event.no-way.cause': 'Der Ort ist unbekannt, belegt oder hinter einer Lücke, durch die er nicht passt',
  'event.no-way.remedy': 'Wähle einen Ort auf freiem Boden',
  'event.stalled': 'Die Räder drehen sich nicht',
  'event.stalled.cause': 'Etwas hält ihn fest, oder ein Motor oder seine Versorgung ist ausgefallen',
  'event.stalled.remedy': 'Mache ihn frei, prüfe Batterien und Motorkabel',
  'event.carried-off': 'Jemand trägt den Roboter weg: Er muss seinen Ort wiederfinden',
  'event.box': 'Jemand stellt eine Kiste hin',
  'event.cable-cut': 'Jemand zieht das Kabel',
  'stopped.stop': 'STOPP wurde gedrückt',
  'stopped.driver-gone': 'Die Seite des Fahrers wurde geschlossen oder verlor die Verbindung',
  'stopped.driver-silent': 'Von der Seite des Fahrers kam 0,25 s lang nichts',
  'stopped.bumped': 'Er hat etwas berührt',
  'stopped.hazard': 'Ein Sensor sah eine Kante oder eine andere Gefahr',
  'stopped.stalled': 'Die Räder drehen sich nicht',
  'stopped.lifted': 'Jemand hat ihn hochgehoben',
  'stopped.no-way': 'Kein bekannter Boden führt dorthin',
  'stopped.arrived': 'Er ist, wohin er geschickt wurde',
};

export const serverTexts: Partial<Record<Language, Partial<Record<string, string>>>> = { de: german };
