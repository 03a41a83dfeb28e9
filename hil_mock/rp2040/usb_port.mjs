// SPDX-License-Identifier: MIT
// The serial interface engine of the USB controller as a host on the cable sees it: one transaction at a
// time, with NAK, STALL and data PIDs, in place of rp2040js' buffers that are always taken at once.

export const kAnswer = { none: 0, ack: 1, nak: 2, stall: 3 };

const kInControls = 0x80;
const kEndpointEnabled = 0x80000000;
const kInterruptEachBuffer = 1 << 29;
const kDoubleBuffer = 1 << 30;
const kAvailable = 1 << 10;
const kStall = 1 << 11;
const kData1 = 1 << 13;
const kFull = 1 << 15;
const kLengthMask = 0x3ff;
const kPullUp = 1 << 16;
const kEp0EachBuffer = 1 << 29;
const kBusReset = 1 << 19;
const kSetup = 1 << 17;
const kSuspended = 1 << 4;
const kResume = 1 << 11;
const kVbus = 1 << 0;
const kSequenceError = 0x80000000;
const kEp0Data = 0x100;
const kBulkEndpoint = 2;

export class UsbPort {
  /** `onReady()` is called when the program has given a buffer to the controller. */
  constructor(usb, onReady) {
    this.usb = usb;
    this.plugged = false;
    usb.DPRAMUpdated = (offset, value) => {
      if (offset >= kInControls && offset < 0x100 && value & kAvailable) {
        onReady();
      }
    };
  }

  /** Whether a host sees the pull-up. */
  isAttached() {
    return this.plugged && (this.usb.mainCtrl & 1) !== 0 && (this.usb.sieCtrl & kPullUp) !== 0;
  }

  plug(plugged) {
    this.plugged = plugged;
    const { usb } = this;
    if (plugged) {
      usb.sieStatus |= kVbus;
      usb.sieStatus &= ~kSuspended;
    } else {
      usb.sieStatus = (usb.sieStatus & ~kVbus) | kSuspended;
    }
    usb.sieStatusUpdated();
  }

  resetBus() {
    this.usb.sieStatus = (this.usb.sieStatus | kBusReset) & ~kSuspended;
    this.usb.sieStatusUpdated();
  }

  suspend() {
    this.usb.sieStatus |= kSuspended;
    this.usb.sieStatusUpdated();
  }

  /** Frames again; the controller tells the program so only where it has `noticed` the resume itself. */
  resume(noticed) {
    this.usb.sieStatus = (this.usb.sieStatus | (noticed ? kResume : 0)) & ~kSuspended;
    this.usb.sieStatusUpdated();
  }

  answersTo(address) {
    return this.isAttached() && (this.usb.addrEndp & 0x7f) === address;
  }

  setup(address, bytes) {
    if (!this.answersTo(address)) {
      return kAnswer.none;
    }
    this.usb.rp2040.usbDPRAM.set(bytes.subarray(0, 8));
    this.usb.epStallArm &= ~3;
    this.usb.sieStatus |= kSetup;
    this.usb.sieStatusUpdated();
    return kAnswer.ack;
  }

  /** Answers an IN token: {answer, data1, bytes}. */
  in(address, endpoint) {
    const pipe = this.pipe(address, endpoint, false);
    if (pipe.answer !== kAnswer.ack || !(pipe.control & kFull)) {
      return { answer: pipe.answer === kAnswer.ack ? kAnswer.nak : pipe.answer };
    }
    const length = pipe.control & kLengthMask;
    const bytes = this.usb.rp2040.usbDPRAM.slice(pipe.data, pipe.data + length);
    this.finish(pipe, pipe.control & ~(kAvailable | kFull), endpoint, false);
    return { answer: kAnswer.ack, data1: (pipe.control & kData1) !== 0, bytes };
  }

  /** Whether an IN token to the bulk endpoint gets anything but a NAK. */
  hasBulkIn() {
    const pipe = this.pipe(this.usb.addrEndp & 0x7f, kBulkEndpoint, false);
    return pipe.answer === kAnswer.ack ? (pipe.control & kFull) !== 0 : pipe.answer === kAnswer.stall;
  }

  /** Answers an OUT token with its data. */
  out(address, endpoint, data1, bytes) {
    const pipe = this.pipe(address, endpoint, true);
    if (pipe.answer !== kAnswer.ack) {
      return pipe.answer;
    }
    if (data1 !== ((pipe.control & kData1) !== 0)) {
      this.usb.sieStatus |= kSequenceError;
      this.usb.sieStatusUpdated();
      return kAnswer.ack;
    }
    const length = Math.min(bytes.length, pipe.control & kLengthMask);
    this.usb.rp2040.usbDPRAM.set(bytes.subarray(0, length), pipe.data);
    this.finish(pipe, (pipe.control & ~(kAvailable | kLengthMask)) | kFull | length, endpoint, true);
    return kAnswer.ack;
  }

  pipe(address, endpoint, out) {
    const view = this.usb.rp2040.usbDPRAMView;
    const at = kInControls + 8 * endpoint + (out ? 4 : 0);
    const control = view.getUint32(at, true);
    if (!this.answersTo(address)) {
      return { answer: kAnswer.none };
    }
    let data = kEp0Data;
    let each = (this.usb.sieCtrl & kEp0EachBuffer) !== 0;
    let stalls = (control & kStall) !== 0;
    if (endpoint === 0) {
      stalls = stalls && (this.usb.epStallArm & (out ? 2 : 1)) !== 0;
    } else {
      const settings = this.usb.readEndpointControlReg(endpoint, out);
      if (!(settings & kEndpointEnabled)) {
        return { answer: kAnswer.none };
      }
      if (settings & kDoubleBuffer) {
        throw new Error('double buffers of USB endpoints are not emulated');
      }
      data = settings & 0xffc0;
      each = (settings & kInterruptEachBuffer) !== 0;
    }
    if (stalls) {
      return { answer: kAnswer.stall };
    }
    return { answer: control & kAvailable ? kAnswer.ack : kAnswer.nak, at, control, data, each };
  }

  finish(pipe, control, endpoint, out) {
    this.usb.rp2040.usbDPRAMView.setUint32(pipe.at, control >>> 0, true);
    if (pipe.each) {
      this.usb.indicateBufferReady(endpoint, out);
    }
  }
}
