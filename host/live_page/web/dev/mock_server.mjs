// SPDX-License-Identifier: MIT
// For developers of the page: speaks docs/live_protocol.md, and serves the built page as echomap does.
//   node dev/mock_server.mjs [--port 8091] [--cells 200] [--particles 5000] [--filled] [--recorded] [--recorded-s 120]
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { parseArgs } from 'node:util';
import { WebSocketServer } from 'ws';
import { MockRun } from './mock_run.mjs';

const { values: options } = parseArgs({
  options: {
    port: { type: 'string', default: '8091' },
    cells: { type: 'string', default: '200' },
    particles: { type: 'string', default: '5000' },
    filled: { type: 'boolean', default: false },
    recorded: { type: 'boolean', default: false },
    'recorded-s': { type: 'string', default: '120' },
  },
});

const size = { cells: Number(options.cells), particles: Number(options.particles), filled: options.filled };
const runs = [];
if (!options.recorded) runs.push({ id: '0', name: 'first_map', live: true, finished: false, run: new MockRun(size) });
runs.push({ id: '1', name: 'kitchen', live: false, finished: true, run: recordedRun() });
const live = runs.find((entry) => entry.live)?.run;
live?.begin();

function recordedRun() {
  const run = new MockRun({ ...size, filled: false });
  run.begin(false);
  const seconds = Number(options['recorded-s']);
  for (let tick = 0; tick < seconds * 20; ++tick) {
    if (tick === seconds * 10) run.take({ do: 'carry-off' }, null);
    run.tick();
  }
  run.mode = 'ended';
  run.result = { finished: true, why: 'complete: every opening was looked into', next: 'echomap localize --map kitchen' };
  run.sendState(false);
  return run;
}

const files = new Map([
  ['map.pgm', { media_type: 'image/x-portable-graymap', content: 'P2 1 1 255 255\n' }],
  ['report.json', { media_type: 'application/json', content: '{}' }],
]);
const pageTypes = { 'index.html': 'text/html', 'app.js': 'text/javascript', 'app.css': 'text/css', 'favicon.svg': 'image/svg+xml' };

function encodedHistory(messages) {
  return Buffer.concat(
    messages.flatMap((bytes) => {
      const length = Buffer.alloc(4);
      length.writeUInt32LE(bytes.length);
      return [length, bytes];
    }),
  );
}

function answer(response, status, type, content) {
  response.writeHead(status, { 'Content-Type': type, 'Content-Security-Policy': "default-src 'self'" });
  response.end(content);
}
const answerJson = (response, value) => answer(response, 200, 'application/json', JSON.stringify(value));

const server = createServer(async (request, response) => {
  const { pathname } = new URL(request.url, 'http://localhost');
  const [, , , , id, what, name] = pathname.split('/');
  const entry = runs.find((candidate) => candidate.id === id);
  if (pathname === '/api/v1/runs') {
    answerJson(response, runs.map(({ run: _, ...shown }) => shown));
  } else if (pathname === '/api/v1/commands' && request.method === 'POST') {
    let body = '';
    for await (const part of request) body += part;
    answerJson(response, take(JSON.parse(body), null));
  } else if (entry && what === 'history') {
    answer(response, 200, 'application/octet-stream', encodedHistory(entry.run.history));
  } else if (entry && what === 'files' && files.has(name)) {
    answer(response, 200, files.get(name).media_type, files.get(name).content);
  } else if (entry && what === 'files') {
    answerJson(response, [...files].map(([file, { media_type, content }]) => ({ name: file, bytes: content.length, media_type })));
  } else {
    const page = pathname === '/' ? 'index.html' : pathname.slice(1);
    if (!(page in pageTypes)) return answer(response, 404, 'text/plain', 'not found');
    answer(response, 200, pageTypes[page], await readFile(new URL(`../../built_page/${page}`, import.meta.url)));
  }
});

function take(command, client) {
  const { seq } = command;
  if (command.do === 'ping') return { ack: seq, ok: true, clock: performance.now() };
  if (command.do === 'name') {
    client.name = command.name;
    return { ack: seq, ok: true };
  }
  const refusal = live ? live.take(command, client) : { code: 'not-possible', why: 'no run is live' };
  return refusal ? { ack: seq, ok: false, ...refusal } : { ack: seq, ok: true };
}

const clients = new Set();
let clientNumber = 0;
const sockets = new WebSocketServer({ noServer: true, handleProtocols: () => 'echomap.v1' });
server.on('upgrade', (request, socket, head) => {
  if (!live) return socket.destroy();
  sockets.handleUpgrade(request, socket, head, (line) => {
    const client = { number: ++clientNumber, name: 'somebody', line };
    clients.add(client);
    live.clients = clients.size;
    line.send(JSON.stringify({ client: client.number }));
    for (const bytes of live.snapshot()) line.send(bytes);
    line.on('message', (text) => line.send(JSON.stringify(take(JSON.parse(text.toString()), client))));
    line.on('close', () => {
      clients.delete(client);
      live.clients = clients.size;
      live.leave(client);
    });
  });
});

if (live) {
  live.onMessage = (bytes) => {
    for (const { line } of clients) if (line.bufferedAmount < 1e6) line.send(bytes);
  };
  setInterval(() => {
    for (let step = 0; step < Math.max(1, Math.min(50, live.speed || 50)); ++step) live.tick();
  }, 50);
}
server.listen(Number(options.port), '127.0.0.1', () => console.log(`http://127.0.0.1:${options.port}/`));
