// SPDX-License-Identifier: MIT
// Reads a release image and checks what the boot ROM of an RP2040 checks.
import fs from 'node:fs';

const kFlashStart = 0x10000000;
const kFlashBytes = 2 * 1024 * 1024;
const kBoot2Bytes = 252;
const kElfMagic = 0x464c457f;
const kLoadSegment = 1;

/** CRC-32 as the boot ROM computes it: 04C11DB7, from FFFFFFFF, nothing reflected or inverted. */
export function boot2Crc(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte << 24;
    for (let bit = 0; bit < 8; ++bit) {
      crc = crc & 0x80000000 ? (crc << 1) ^ 0x04c11db7 : crc << 1;
    }
  }
  return crc >>> 0;
}

/** Whether the boot ROM would start this flash. */
export function hasValidBoot2(flash) {
  const stored = Buffer.from(flash.buffer, flash.byteOffset, flash.length).readUInt32LE(kBoot2Bytes);
  return boot2Crc(flash.subarray(0, kBoot2Bytes)) === stored;
}

function copySegments(file, flash) {
  const header = file.readUInt32LE(28);
  const bytesOfEntry = file.readUInt16LE(42);
  for (let index = 0; index < file.readUInt16LE(44); ++index) {
    const entry = header + index * bytesOfEntry;
    const from = file.readUInt32LE(entry + 4);
    const to = file.readUInt32LE(entry + 12) - kFlashStart;
    const bytes = file.readUInt32LE(entry + 16);
    if (file.readUInt32LE(entry) === kLoadSegment && bytes > 0) {
      if (to < 0 || to + bytes > flash.length) {
        throw new Error('the image does not fit into the flash');
      }
      flash.set(file.subarray(from, from + bytes), to);
    }
  }
}

/** The flash with the image of `path`, an ELF or the plain bytes. */
export function readImage(path) {
  const flash = new Uint8Array(kFlashBytes).fill(0xff);
  const file = fs.readFileSync(path);
  if (file.length >= 52 && file.readUInt32LE(0) === kElfMagic) {
    copySegments(file, flash);
  } else if (file.length > flash.length) {
    throw new Error('the image does not fit into the flash');
  } else {
    flash.set(file);
  }
  return flash;
}
