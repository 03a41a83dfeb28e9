// SPDX-License-Identifier: MIT
// The devices on I2C0, at the pace of its clock. `ask` reads and writes their registers.

const kBitsOfByte = 9;
const kSda = 20;
/** IC_INTR_MASK, which rp2040js has for reading only. */
const kInterruptMask = 0x30;
/** IC_ENABLE: 0 in the middle of a transfer leaves the block active, until it is reset. */
const kEnable = 0x6c;

export class TwoWire {
  constructor(i2c, clock, nsOfCycle, ask) {
    this.i2c = i2c;
    this.clock = clock;
    this.nsOfCycle = nsOfCycle;
    this.ask = ask;
    this.device = -1;
    this.register = -1;
    this.then = () => {};
    this.alarm = clock.createAlarm(() => this.then());
    this.heldBits = 0;
    this.isStuck = false;
    const write = i2c.writeUint32.bind(i2c);
    i2c.writeUint32 = (offset, value) => {
      if (offset === kInterruptMask) {
        i2c.intEnable = value;
        i2c.checkInterrupts();
      } else if (!this.isStuck) {
        if (offset === kEnable && !(value & 1)) {
          this.isStuck = i2c.busy;
          this.alarm.cancel();
        }
        write(offset, value);
      }
    };
    i2c.onStart = () => this.after(1, () => i2c.completeStart());
    i2c.onConnect = (address) => this.after(kBitsOfByte, () => this.connect(address));
    i2c.onWriteByte = (value) => this.after(kBitsOfByte, () => this.write(value));
    i2c.onReadByte = () =>
      this.after(kBitsOfByte, () => i2c.completeRead(this.ask.read(this.device, this.register++)));
    i2c.onStop = () => this.after(1, () => i2c.completeStop());
  }

  /** By the RESETS block. */
  reset() {
    const { i2c } = this;
    this.alarm.cancel();
    this.isStuck = false;
    Object.assign(i2c, { state: 0, busy: false, stop: false, pendingRestart: false, enable: 0 });
    Object.assign(i2c, { intRaw: 0, intEnable: 0, abortSource: 0 });
    i2c.txFIFO.reset();
    i2c.rxFIFO.reset();
    i2c.checkInterrupts();
  }

  /** A device sends: data stays low for so many clocks. */
  hold(bits, pins) {
    this.heldBits = bits;
    pins.drive(kSda, false);
  }

  /** The clock line has risen by the program's hand. */
  clockRose(pins) {
    if (this.heldBits > 0 && --this.heldBits === 0) {
      pins.release(kSda);
    }
  }

  after(bits, then) {
    if (this.heldBits > 0) {
      return;
    }
    const { i2c } = this;
    this.then = then;
    this.alarm.schedule(bits * (i2c.sclLowPeriod + i2c.sclHighPeriod) * this.nsOfCycle());
  }

  connect(address) {
    this.device = address;
    const answers = this.ask.has(address);
    if (this.i2c.txFIFO.itemCount > 0 && !(this.i2c.txFIFO.peek() & 0x100)) {
      this.register = -1;
    }
    this.i2c.completeConnect(answers);
  }

  write(value) {
    if (this.register < 0) {
      this.register = value;
    } else {
      this.ask.write(this.device, this.register++, value);
    }
    this.i2c.completeWrite(true);
  }
}
