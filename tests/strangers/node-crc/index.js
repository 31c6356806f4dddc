'use strict';

// Stands in for the package of this name, which wants a compiler and node's headers to be installed. canopen calls one
// function of it, with one set of arguments: the CRC of CiA 301's SDO block transfer, CRC-16 with polynomial 1021h
// from the most significant bit on, starting at 0.
exports.crc = function crc(bits, reflect, poly, polyHigh, initial, initialHigh, xor, xorHigh, data) {
  if (bits !== 16 || reflect || poly !== 0x1021 || initial !== 0 || xor !== 0) {
    throw new Error('only CRC-16/1021h from 0 is known here');
  }
  let sum = 0;
  for (const byte of data) {
    sum ^= byte << 8;
    for (let bit = 0; bit < 8; ++bit) {
      sum = (sum & 0x8000 ? (sum << 1) ^ 0x1021 : sum << 1) & 0xffff;
    }
  }
  return Buffer.from([sum >> 8, sum & 0xff]);
};
