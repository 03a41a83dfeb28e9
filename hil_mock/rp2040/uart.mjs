// SPDX-License-Identifier: MIT
// The PL011 with queues that the wire empties and fills at its baud rate, in place of rp2040js' UART.

const kRegister = {
  data: 0x00, flags: 0x18, control: 0x30, levels: 0x34, mask: 0x38, raw: 0x3c, masked: 0x40, clear: 0x44,
};
const kFifoBytes = 32;
const kBitsOfByte = 10;
const kTimeoutBits = 32;
const kBusy = 1 << 3;
const kReceiveEmpty = 1 << 4;
const kTransmitFull = 1 << 5;
const kReceiveFull = 1 << 6;
const kTransmitEmpty = 1 << 7;
const kReceiveInterrupt = 1 << 4;
const kTransmitInterrupt = 1 << 5;
const kTimeoutInterrupt = 1 << 6;
const kOverrunInterrupt = 1 << 10;
const kOverrunOfData = 1 << 11;
const kResetLevels = 0x12;
const kThresholds = [4, 8, 16, 24, 28, 16, 16, 16];

export class Uart {
  /** `emit(byte)` is called when a byte's stop bit is over. */
  constructor(uart, clock, emit) {
    this.uart = uart;
    this.clock = clock;
    this.emit = emit;
    this.sending = [];
    this.arriving = [];
    this.received = [];
    this.raw = 0;
    this.levels = kResetLevels;
    this.overrun = false;
    this.sent = clock.createAlarm(() => this.finishSending());
    this.arrived = clock.createAlarm(() => this.finishArriving());
    this.timeout = clock.createAlarm(() => this.raise(kTimeoutInterrupt));
    this.hookRegisters();
  }

  /** Bytes on the receive line from now on, one behind the other. */
  receive(bytes) {
    const isIdle = this.arriving.length === 0;
    this.arriving.push(...bytes);
    if (isIdle && this.arriving.length > 0) {
      this.arrived.schedule(this.byteNs());
    }
  }

  byteNs() {
    const baud = this.uart.baudDivider > 0 ? this.uart.baudRate : 9600;
    return Math.round((kBitsOfByte * 1e9) / baud);
  }

  depth() {
    return this.uart.fifosEnabled ? kFifoBytes : 1;
  }

  threshold(shift) {
    return this.uart.fifosEnabled ? kThresholds[(this.levels >> shift) & 7] : 1;
  }

  finishArriving() {
    const byte = this.arriving.shift();
    if (this.arriving.length > 0) {
      this.arrived.schedule(this.byteNs());
    }
    if (!this.uart.enabled || !this.uart.rxEnabled) {
      return;
    }
    if (this.received.length >= this.depth()) {
      this.overrun = true;
      this.raise(kOverrunInterrupt);
      return;
    }
    this.received.push(byte | (this.overrun ? kOverrunOfData : 0));
    this.overrun = false;
    this.timeout.schedule((this.byteNs() / kBitsOfByte) * kTimeoutBits);
    if (this.received.length >= this.threshold(3)) {
      this.raise(kReceiveInterrupt);
    }
  }

  finishSending() {
    const byte = this.sending.shift();
    if (this.sending.length > 0) {
      this.sent.schedule(this.byteNs());
    }
    if (this.waiting() === this.lowWater()) {
      this.raise(kTransmitInterrupt);
    }
    this.emit(byte);
  }

  /** Bytes behind the one that is on the wire. */
  waiting() {
    return Math.max(this.sending.length - 1, 0);
  }

  lowWater() {
    return this.uart.fifosEnabled ? kThresholds[this.levels & 7] : 0;
  }

  raise(bits) {
    this.raw |= bits;
    this.tell();
  }

  drop(bits) {
    this.raw &= ~bits;
    this.tell();
  }

  tell() {
    this.uart.rp2040.setInterrupt(this.uart.irq, (this.raw & this.uart.interruptMask) !== 0);
  }

  readData() {
    const value = this.received.shift() ?? 0;
    if (this.received.length < this.threshold(3)) {
      this.drop(kReceiveInterrupt);
    }
    if (this.received.length === 0) {
      this.timeout.cancel();
      this.drop(kTimeoutInterrupt);
    }
    return value;
  }

  writeData(byte) {
    if (!this.uart.enabled || !this.uart.txEnabled || this.waiting() >= this.depth()) {
      return;
    }
    this.sending.push(byte);
    if (this.sending.length === 1) {
      this.sent.schedule(this.byteNs());
    }
    if (this.waiting() > this.lowWater()) {
      this.drop(kTransmitInterrupt);
    }
  }

  flags() {
    return (this.sending.length > 0 ? kBusy : 0) | (this.received.length === 0 ? kReceiveEmpty : 0) |
           (this.waiting() >= this.depth() ? kTransmitFull : 0) |
           (this.received.length >= this.depth() ? kReceiveFull : 0) |
           (this.waiting() === 0 ? kTransmitEmpty : 0);
  }

  hookRegisters() {
    const { uart } = this;
    const read = uart.readUint32.bind(uart);
    const write = uart.writeUint32.bind(uart);
    uart.readUint32 = (offset) => {
      switch (offset) {
        case kRegister.data: return this.readData();
        case kRegister.flags: return this.flags();
        case kRegister.levels: return this.levels;
        case kRegister.raw: return this.raw;
        case kRegister.masked: return this.raw & uart.interruptMask;
        default: return read(offset);
      }
    };
    uart.writeUint32 = (offset, value) => {
      switch (offset) {
        case kRegister.data: this.writeData(value & 0xff); break;
        case kRegister.levels: this.levels = value & 0x3f; break;
        case kRegister.clear: this.drop(uart.rawWriteValue & 0x7ff); break;
        default: write(offset, value);
      }
    };
    uart.checkInterrupts = () => this.tell();
  }
}
