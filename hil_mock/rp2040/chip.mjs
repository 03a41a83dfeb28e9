// SPDX-License-Identifier: MIT
// An RP2040 of rp2040js in simulated time, and the repairs that README.md lists.
import { createRequire } from 'node:module';
import path from 'node:path';
import { hasValidBoot2 } from './image.mjs';
import { LoadMeter } from './load_meter.mjs';
import { PioStepper } from './pio_stepper.mjs';
import { Pins } from './pins.mjs';
import { TwoWire } from './two_wire.mjs';
import { Uart } from './uart.mjs';
import { UsbPort } from './usb_port.mjs';

const { RP2040 } = createRequire(path.join(process.argv[3] ?? process.cwd(), 'package.json'))('rp2040js');

const kBoot2Ram = 0x41f00;
const kBoot2Bytes = 256;
const kStackTop = 0x20042000;
const kTick = 0x2c;
const kTickOn = 1 << 9;
const kTickRuns = 1 << 10;
const kCrystalMhz = 12;
const kChipReset = 8;
const kHadPowerOn = 1 << 8;
const kHadRun = 1 << 16;
const kRandomBit = 0x1c;
const kI2c0 = 1 << 3;
const kPeripheral = { resets: 0x4000c, timer: 0x40054, watchdog: 0x40058, rosc: 0x40060, vreg: 0x40064 };

export const kReset = { powerOn: 0, pin: 1, watchdog: 2 };

/** Time of the TIMER block: it counts only while the watchdog's tick generator runs. */
class TickedClock {
  constructor(clock) {
    this.clock = clock;
    this.scale = 0;
    this.baseNs = 0;
    this.sinceNs = clock.nanos;
  }

  get nanos() {
    return this.baseNs + (this.clock.nanos - this.sinceNs) * this.scale;
  }

  set(scale) {
    this.baseNs = this.nanos;
    this.sinceNs = this.clock.nanos;
    this.scale = scale;
  }

  createAlarm(callback) {
    const alarm = this.clock.createAlarm(callback);
    return {
      schedule: (ns) => (this.scale > 0 ? alarm.schedule(ns / this.scale) : undefined),
      cancel: () => alarm.cancel(),
    };
  }
}

export class Chip {
  /** `hooks`: onByte(byte), onOutput(pin), onUsbReady(), registers of two-wire devices. */
  constructor(flash, hooks) {
    this.flash = flash;
    this.hooks = hooks;
    this.outside = new Map();
    this.analog = [4095, 4095, 4095, 4095, 0];
    this.resets = 0;
    this.noiseState = 1;
    this.bites = false;
    this.inputs = [];
    this.nextInput = 0;
    this.plugged = false;
    this.load = new LoadMeter(0);
    this.boot(kReset.powerOn);
  }

  get clock() {
    return this.rp2040.clock;
  }

  get now() {
    return this.clock.nanosCounter;
  }

  /** Starts the program again; RAM keeps what it holds but for power-on. */
  reset(cause) {
    ++this.resets;
    this.boot(cause);
    this.hooks.onOutput(-1);
  }

  boot(cause) {
    const old = this.rp2040;
    const rp2040 = new RP2040();
    rp2040.flash.set(this.flash);
    rp2040.clock.nanosCounter = old ? old.clock.nanosCounter : 0;
    rp2040.logger = this.logger();
    this.rp2040 = rp2040;
    this.cycleNs = 1e9 / rp2040.clkSys;
    rp2040.addClockListener((hz) => (this.cycleNs = 1e9 / hz));
    const nsOfCycle = () => this.cycleNs;
    this.pios = rp2040.pio.map((pio) => new PioStepper(pio, rp2040.clock, nsOfCycle));
    this.pins = new Pins(rp2040, {
      beforeInput: () => this.pios.forEach((pio) => pio.catchUp()),
      afterInput: () => this.pios.forEach((pio) => pio.disturb()),
      onOutput: (pin) => this.outputChanged(pin),
    });
    this.uart = new Uart(rp2040.uart[0], rp2040.clock, (byte) => this.hooks.onByte(byte));
    this.usb = new UsbPort(rp2040.usbCtrl, () => this.hooks.onUsbReady());
    this.twoWire = new TwoWire(rp2040.i2c[0], rp2040.clock, nsOfCycle, this.hooks.registers);
    this.repairCore();
    this.repairTick(cause, old);
    this.repairResets();
    this.repairResetCause(cause);
    if (old && cause !== kReset.powerOn) {
      rp2040.sram.set(old.sram);
    } else {
      rp2040.sram.forEach((_, at) => (rp2040.sram[at] = this.noise() >>> 24));
    }
    for (const [pin, high] of this.outside) {
      this.pins.drive(pin, high);
    }
    rp2040.adc.channelValues = this.analog;
    this.usb.plug(this.plugged);
    this.startBoot2();
  }

  startBoot2() {
    if (!hasValidBoot2(this.flash)) {
      throw new Error('the boot ROM finds no second stage: its checksum is wrong');
    }
    const { core, sram } = this.rp2040;
    sram.set(this.flash.subarray(0, kBoot2Bytes), kBoot2Ram);
    core.PC = 0x20000000 + kBoot2Ram;
    core.SP = kStackTop;
    core.LR = 0;
  }

  logger() {
    const fail = (name, message) => {
      if (/invalid memory|undefined address|not implemented|not 32 bit/.test(message)) {
        const { core } = this.rp2040;
        throw new Error(`${name}: ${message} (near ${core.PC.toString(16)})`);
      }
    };
    return { debug() {}, info() {}, warn: fail, error: fail };
  }

  /** WFI wakes by what is pending even with interrupts locked, and the handler waits for the lock. */
  repairCore() {
    const { core } = this.rp2040;
    core.setInterrupt = (irq, high) => {
      const bit = 1 << irq;
      if (!high) {
        core.pendingInterrupts &= ~bit;
      } else if (!(core.pendingInterrupts & bit)) {
        core.pendingInterrupts |= bit;
        core.interruptsUpdated = true;
        if (core.enabledInterrupts & bit) {
          core.waiting = false;
        }
      }
    };
    const enter = core.exceptionEntry.bind(core);
    core.exceptionEntry = (exception) => {
      this.load.enter(exception, this.now);
      enter(exception);
    };
  }

  /** Measures `load` anew. */
  meterLoad() {
    this.load = new LoadMeter(this.now);
  }

  repairTick(cause, old) {
    const timer = this.rp2040.peripherals[kPeripheral.timer];
    const watchdog = this.rp2040.peripherals[kPeripheral.watchdog];
    const ticked = new TickedClock(this.rp2040.clock);
    timer.clock = ticked;
    timer.alarms.forEach((alarm, index) => {
      alarm.clockAlarm = ticked.createAlarm(() => timer.fireAlarm(index));
    });
    watchdog.tickEnable = false;
    const read = watchdog.readUint32.bind(watchdog);
    const write = watchdog.writeUint32.bind(watchdog);
    let tick = 0;
    watchdog.readUint32 = (offset) =>
      offset === kTick ? tick | (ticked.scale > 0 ? kTickRuns : 0) : read(offset);
    watchdog.writeUint32 = (offset, value) => {
      if (offset === kTick) {
        tick = value & (kTickOn | 0x1ff);
        const cycles = value & 0x1ff;
        ticked.set(value & kTickOn && cycles > 0 ? kCrystalMhz / cycles : 0);
        write(offset, cycles > 0 ? value : 0);
      } else {
        write(offset, value);
      }
    };
    watchdog.onWatchdogTrigger = () => {
      watchdog.alarm.enable = false; // Else it comes again at once, and time stands still.
      watchdog.timer.enable = false;
      this.bites = true;
    };
    if (old && cause !== kReset.powerOn) {
      const last = old.peripherals[kPeripheral.watchdog];
      if (cause === kReset.watchdog) {
        watchdog.scratchData.set(last.scratchData);
        watchdog.reason = last.reason;
      }
    }
  }

  /** RESETS resets nothing in rp2040js. */
  repairResets() {
    const resets = this.rp2040.peripherals[kPeripheral.resets];
    const write = resets.writeUint32.bind(resets);
    resets.writeUint32 = (offset, value) => {
      write(offset, value);
      if (resets.reset & kI2c0) {
        this.twoWire.reset();
      }
    };
  }

  /** Why the chip was reset, and the ring oscillator's noise, which are stubs in rp2040js. */
  repairResetCause(cause) {
    const vreg = this.rp2040.peripherals[kPeripheral.vreg];
    const rosc = this.rp2040.peripherals[kPeripheral.rosc];
    const bits = cause === kReset.powerOn ? kHadPowerOn : kHadRun;
    this.causeBits = cause === kReset.watchdog ? this.causeBits : bits;
    vreg.readUint32 = (offset) => (offset === kChipReset ? this.causeBits : 0);
    rosc.readUint32 = (offset) => (offset === kRandomBit ? this.noise() >>> 31 : 0);
    vreg.writeUint32 = rosc.writeUint32 = () => {};
  }

  /** 32 bits of Numerical Recipes' generator, the same in every run. */
  noise() {
    this.noiseState = (Math.imul(this.noiseState, 1664525) + 1013904223) >>> 0;
    return this.noiseState;
  }

  outputChanged(pin) {
    if (pin === 21 && this.rp2040.gpio[21].rawInputValue) {
      this.twoWire.clockRose(this.pins);
    }
    this.hooks.onOutput(pin);
  }

  /** A level from outside, at `atNs` and not before now. */
  schedule(atNs, pin, high) {
    let index = this.inputs.length;
    while (index > this.nextInput && this.inputs[index - 1].atNs > atNs) {
      --index;
    }
    this.inputs.splice(index, 0, { atNs, pin, high });
  }

  applyInputs() {
    while (this.nextInput < this.inputs.length && this.inputs[this.nextInput].atNs <= this.now) {
      const { pin, high } = this.inputs[this.nextInput++];
      this.outside.set(pin, high);
      this.pins.drive(pin, high);
    }
    if (this.nextInput === this.inputs.length) {
      this.inputs = [];
      this.nextInput = 0;
    }
  }

  /** Runs up to `untilNs`, or until a hook has asked to stop. */
  run(untilNs) {
    this.stop = false;
    while (!this.stop && this.now < untilNs) {
      this.applyInputs();
      const next = this.nextInput < this.inputs.length ? this.inputs[this.nextInput].atNs : untilNs;
      this.runTo(Math.min(next, untilNs));
      if (this.bites) {
        this.bites = false;
        this.reset(kReset.watchdog);
      }
    }
    this.applyInputs();
  }

  runTo(limitNs) {
    const { core, clock } = this.rp2040;
    while (!this.stop && !this.bites && clock.nanosCounter < limitNs) {
      if (core.waiting && (core.pendingInterrupts & core.enabledInterrupts || core.pendingSystick)) {
        core.waiting = false;
      }
      if (core.waiting) {
        const alarm = clock.nextAlarm;
        const ns = Math.max(Math.min(alarm ? alarm.nanos : limitNs, limitNs) - clock.nanosCounter, 0);
        this.load.sleep(ns);
        clock.tick(ns);
      } else {
        clock.nanosCounter += core.executeInstruction() * this.cycleNs;
        if (clock.nextAlarm && clock.nextAlarm.nanos <= clock.nanosCounter) {
          clock.tick(0);
        }
      }
    }
  }
}
