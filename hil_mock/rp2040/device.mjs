// SPDX-License-Identifier: MIT
// node device.mjs IMAGE MODULES: the chip behind a pair of pipes. Each message is its length in four
// bytes and orders or events one behind the other; README.md lists them. Times are nanoseconds.
import fs from 'node:fs';
import { Chip } from './chip.mjs';
import { readImage } from './image.mjs';

const kTriggerPin = 6;
const kFrameNs = 1e6;
const kReported = [6, 8, 9, 10, 11, 12, 13, 14, 15, 18, 19, 20, 21, 22, 26, 27, 28];

for (const name of ['log', 'info', 'debug', 'warn']) {
  console[name] = console.error;
}

function readExactly(bytes) {
  const buffer = Buffer.alloc(bytes);
  for (let got = 0; got < bytes; ) {
    const more = fs.readSync(0, buffer, got, bytes - got, null);
    if (more === 0) {
      process.exit(0);
    }
    got += more;
  }
  return buffer;
}

const readMessage = () => readExactly(readExactly(4).readUInt32LE(0));

class Answer {
  constructor() {
    this.buffer = Buffer.alloc(1 << 16);
    this.clear();
  }

  clear() {
    this.at = 4;
  }

  room(bytes) {
    if (this.at + bytes > this.buffer.length) {
      this.buffer = Buffer.concat([this.buffer, Buffer.alloc(this.buffer.length)]);
    }
  }

  byte(value) {
    this.room(1);
    this.at = this.buffer.writeUInt8(value, this.at);
  }

  word(value) {
    this.room(4);
    this.at = this.buffer.writeUInt32LE(value >>> 0, this.at);
  }

  number(value) {
    this.room(8);
    this.at = this.buffer.writeDoubleLE(value, this.at);
  }

  bytes(values) {
    this.room(values.length + 4);
    this.word(values.length);
    this.buffer.set(values, this.at);
    this.at += values.length;
  }

  send() {
    this.buffer.writeUInt32LE(this.at - 4, 0);
    for (let sent = 0; sent < this.at; ) {
      sent += fs.writeSync(1, this.buffer, sent, this.at - sent);
    }
    this.clear();
  }
}

class Device {
  constructor(image) {
    this.answer = new Answer();
    this.addresses = new Set();
    this.trigger = false;
    this.wakesForUsb = false;
    this.pollNs = 0;
    this.chip = new Chip(readImage(image), {
      onByte: (byte) => {
        this.event('S');
        this.answer.byte(byte);
      },
      onOutput: (pin) => this.pinsChanged(pin),
      onUsbReady: () => {
        if (this.wakesForUsb) {
          this.chip.stop = true;
        }
      },
      registers: {
        has: (address) => this.addresses.has(address),
        read: (address, register) => this.askRegister('r', address, register, 0),
        write: (address, register, value) => this.askRegister('w', address, register, value),
      },
    });
  }

  event(kind) {
    this.answer.byte(kind.charCodeAt(0));
    this.answer.number(this.chip ? this.chip.now : 0);
  }

  askRegister(kind, address, register, value) {
    this.event(kind);
    this.answer.byte(address);
    this.answer.byte(register & 0xff);
    this.answer.byte(value);
    this.answer.send();
    return readMessage().readUInt8(0);
  }

  pinsChanged(pin) {
    if (!this.chip) {
      return;
    }
    this.event('P');
    const pins = this.chip.pins;
    this.answer.byte(kReported.length);
    for (const index of kReported) {
      const { driven, pulledUp, from, until, periodUs } = pins.signal(index);
      this.answer.byte(index);
      this.answer.byte(driven ? 2 : pulledUp ? 1 : 0);
      this.answer.number(from);
      this.answer.number(until);
      this.answer.number(periodUs);
    }
    const trigger = this.chip.rp2040.gpio[kTriggerPin].rawInputValue;
    if (pin === kTriggerPin && this.trigger && !trigger) {
      this.chip.stop = true;
    }
    this.trigger = trigger;
  }

  serve() {
    const message = readMessage();
    for (let at = 0; at < message.length; ) {
      at = this.obey(message, at);
    }
    this.event('E');
    this.answer.word(this.chip.resets);
    this.answer.byte(this.chip.usb.isAttached() ? 1 : 0);
    this.answer.byte(this.chip.usb.hasBulkIn() ? 1 : 0);
    this.answer.number(this.pollNs);
    this.answer.send();
  }

  /** Carries out the order at `at` and returns where the next one begins. */
  obey(message, at) {
    const chip = this.chip;
    switch (String.fromCharCode(message.readUInt8(at))) {
      case 'L':
        chip.schedule(message.readDoubleLE(at + 1), message.readUInt8(at + 9), message.readUInt8(at + 10) !== 0);
        return at + 11;
      case 'A':
        chip.analog[message.readUInt8(at + 1)] = message.readUInt16LE(at + 2);
        return at + 4;
      case 'B': {
        const end = at + 5 + message.readUInt32LE(at + 1);
        chip.uart.receive(message.subarray(at + 5, end));
        return end;
      }
      case 'D':
        this.addresses.add(message.readUInt8(at + 1));
        return at + 2;
      case 'R':
        chip.reset(message.readUInt8(at + 1));
        return at + 2;
      case 'G':
        this.wakesForUsb = message.readUInt8(at + 9) !== 0;
        this.run(message.readDoubleLE(at + 1), message.readDoubleLE(at + 10));
        return at + 18;
      default:
        return this.obeyTester(message, at);
    }
  }

  /** Until then; `pollNs` is when a host that has nothing to send polls next, 0 for none that does. */
  run(untilNs, pollNs) {
    const { chip } = this;
    this.pollNs = pollNs;
    if (pollNs === 0) {
      chip.run(untilNs);
      return;
    }
    do {
      chip.run(Math.min(untilNs, this.pollNs));
      const now = Math.round(chip.now);
      if (now >= this.pollNs) {
        if (!chip.usb.isAttached() || chip.usb.hasBulkIn()) {
          return;
        }
        if (!chip.stop) {
          this.pollNs = now + kFrameNs;
        }
      }
    } while (!chip.stop && chip.now < untilNs);
  }

  obeyTester(message, at) {
    const chip = this.chip;
    switch (String.fromCharCode(message.readUInt8(at))) {
      case 'U':
        return this.transact(message, at);
      case 'V':
        chip.plugged = message.readUInt8(at + 1) !== 0;
        chip.usb.plug(chip.plugged);
        return at + 2;
      case 'K':
        chip.rp2040.writeUint32(message.readUInt32LE(at + 1), message.readUInt32LE(at + 5));
        return at + 9;
      case 'k':
        this.event('k');
        this.answer.word(chip.rp2040.readUint32(message.readUInt32LE(at + 1)));
        return at + 5;
      case 'J':
        chip.rp2040.core.PC = message.readUInt32LE(at + 1);
        chip.rp2040.core.waiting = false;
        return at + 5;
      case 'M':
        chip.meterLoad();
        return at + 1;
      case 'm':
        this.event('m');
        this.answer.number(chip.load.busyShare(chip.now));
        this.answer.number(chip.load.tickJitterNs);
        return at + 1;
      case 'H':
        chip.twoWire.hold(message.readUInt8(at + 1), chip.pins);
        return at + 2;
      default:
        throw new Error(`no such order: ${message.readUInt8(at)}`);
    }
  }

  /** A transaction or a state of the USB cable: U kind address endpoint data1 bytes. */
  transact(message, at) {
    const { usb } = this.chip;
    const kind = String.fromCharCode(message.readUInt8(at + 1));
    const [address, endpoint, data1] = message.subarray(at + 2, at + 5);
    const end = at + 9 + message.readUInt32LE(at + 5);
    const bytes = message.subarray(at + 9, end);
    let result = { answer: 1 };
    switch (kind) {
      case 'R': usb.resetBus(); break;
      case 'P': usb.suspend(); break;
      case 'W': usb.resume(data1 !== 0); break;
      case 'S': result = { answer: usb.setup(address, bytes) }; break;
      case 'O': result = { answer: usb.out(address, endpoint, data1 !== 0, bytes) }; break;
      default: result = usb.in(address, endpoint);
    }
    this.event('U');
    this.answer.byte(result.answer);
    this.answer.byte(result.data1 ? 1 : 0);
    this.answer.bytes(result.bytes ?? []);
    return end;
  }
}

try {
  const device = new Device(process.argv[2]);
  device.pinsChanged(-1);
  for (;;) {
    device.serve();
  }
} catch (error) {
  process.stderr.write(`rp2040js: ${error.message}\n`);
  process.exit(1);
}
