// SPDX-License-Identifier: MIT
// The pins of bank 0: what is driven from outside, what the program drives, and pulls.

const kPins = 30;
const kPadAtReset = 0x56;
const kFunctionPwm = 4;
const kPwmEnabled = 1;
const kInvertA = 1 << 2;

export class Pins {
  /** `onInput()` comes before and after an input changes, `onOutput()` after the program's outputs did. */
  constructor(rp2040, hooks) {
    this.rp2040 = rp2040;
    this.hooks = hooks;
    this.driven = new Array(kPins).fill(false);
    this.level = new Array(kPins).fill(false);
    this.values = 0;
    Object.defineProperty(rp2040, 'gpioValues', { get: () => this.values });
    for (const pin of rp2040.gpio) {
      pin.padValue = kPadAtReset;
      const set = pin.setInputValue.bind(pin);
      pin.setInputValue = (high) => {
        this.hooks.beforeInput();
        set(high);
        this.values = pin.inputValue ? this.values | (1 << pin.index) : this.values & ~(1 << pin.index);
        this.hooks.afterInput();
      };
      pin.addListener(() => {
        this.settle(pin);
        this.hooks.onOutput(pin.index);
      });
    }
    this.tamePwm();
  }

  drive(index, high) {
    this.driven[index] = true;
    this.level[index] = high;
    this.settle(this.rp2040.gpio[index]);
  }

  release(index) {
    this.driven[index] = false;
    this.settle(this.rp2040.gpio[index]);
  }

  /** Gives the pin the level of who drives it: the outside, the program, or a pull. */
  settle(pin) {
    let high = pin.pullupEnabled;
    if (this.driven[pin.index]) {
      high = this.level[pin.index];
    } else if (pin.outputEnable) {
      high = pin.outputValue;
    }
    if (high !== pin.rawInputValue) {
      pin.setInputValue(high);
    }
  }

  /** Of one pin: {driven, pulledUp, from, until, periodUs}. */
  signal(index) {
    const pin = this.rp2040.gpio[index];
    if (pin.functionSelect === kFunctionPwm && pin.outputEnable) {
      return this.pulses(this.rp2040.pwm.channels[(index >> 1) & 7], (index & 1) === 1);
    }
    const high = pin.outputEnable && pin.outputValue;
    return {
      driven: pin.outputEnable,
      pulledUp: !pin.outputEnable && pin.pullupEnabled,
      from: 0,
      until: high ? 1 : 0,
      periodUs: 0,
    };
  }

  pulses(channel, isB) {
    const counts = channel.timer.topValue + 1;
    const compare = this.compareOfNextPulse(channel, isB);
    const share = channel.csr & kPwmEnabled ? Math.min(compare / counts, 1) : 0;
    const inverted = (channel.csr & (isB ? kInvertA << 1 : kInvertA)) !== 0;
    const periodUs = share > 0 && share < 1 ? (channel.timer.toNanos(counts)) / 1000 : 0;
    return {
      driven: true,
      pulledUp: false,
      from: inverted && share < 1 ? share : 0,
      until: inverted ? (share < 1 ? 1 : 0) : share,
      periodUs,
    };
  }

  /** What was written waits for the counter's wrap; a 0 lets the pulse under way end, and none follows. */
  compareOfNextPulse(channel, isB) {
    const latched = isB ? channel.alarmB.target : channel.alarmA.target;
    const written = isB ? channel.cc >>> 16 : channel.cc & 0xffff;
    return channel.ccUpdated && written === 0 ? 0 : latched;
  }

  /** rp2040js toggles the pins at each edge of the pulses; here only their shape is looked at. */
  tamePwm() {
    const { pwm } = this.rp2040;
    pwm.gpioOnInput = (index) => {
      if (!(pwm.gpioDirection & (1 << index))) {
        pwm.channels[(index >> 1) & 7].gpioBChanged();
      }
    };
    for (const channel of pwm.channels) {
      channel.alarmA.enable = false;
      channel.alarmB.enable = false;
      channel.alarmBottom.enable = false;
      const waits = () => channel.ccUpdated || channel.topUpdated || (pwm.intEnable >> channel.index) & 1;
      channel.wrap = () => {
        pwm.channelInterrupt(channel.index);
        channel.updateDoubleBuffered();
        this.hooks.onOutput(2 * channel.index);
        channel.alarmBottom.enable = waits();
      };
      const write = channel.writeRegister.bind(channel);
      channel.writeRegister = (offset, value) => {
        write(offset, value);
        channel.alarmBottom.enable = (channel.csr & kPwmEnabled) !== 0 && waits();
        this.hooks.onOutput(2 * channel.index);
      };
    }
  }
}
