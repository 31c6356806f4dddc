'use strict';

// Slaves of node-canopen are booted by an NMT master of ours: one comes up, though node-canopen sends no boot-up message,
// one is of another vendor, one is not there, and one restarts while it runs.
//
//     node tests/strangers/boot/boot_test.js PEER
//
// PEER is the program of peer.cpp, and its time is ours.

const assert = require('assert');
const {Device, Eds} = require('canopen');
const {Wire, run} = require('../wire');

const OPERATIONAL = 5;

function slave(id, vendor) {
  const eds = new Eds();
  eds.addSdoServerParameter(0, 0x580 + id, 0x600 + id);
  // An NMT reset gives its dictionary the default values.
  const deviceType = eds.getEntry(0x1000);
  deviceType.value = deviceType.defaultValue = 0xf0191;
  const identity = {vendorId: vendor, productCode: 7, revisionNumber: 1, serialNumber: 0xdeadbe00 + id};
  eds.setIdentity(identity, {saveDefault: true});
  return new Device({id, eds});
}

async function main() {
  const good = slave(10, 0x123);
  const foreign = slave(11, 0x124);
  const network = new Wire(process.argv[2]);
  for (const device of [good, foreign]) {
    network.connect(device);
    device.start();
  }
  await network.runUntil(4000);

  // It was reset and asked again, since it sends no boot-up message.
  assert.ok(network.heard.includes('report 10 1 7 - 0 0'), network.heard.join('\n'));
  assert.ok(network.heard.includes('report 10 5 11 - 0 0'), network.heard.join('\n'));
  assert.strictEqual(network.heard.filter((frame) => frame === '000#010A').length, 1);
  assert.strictEqual(good.nmt.state, OPERATIONAL);
  console.log('a slave without a boot-up message comes up');

  assert.ok(network.heard.includes('report 11 4 2 D 123 124'), network.heard.join('\n'));
  assert.ok(!network.heard.includes('000#010B'));
  assert.notStrictEqual(foreign.nmt.state, OPERATIONAL);
  console.log('a slave of another vendor is refused');

  assert.ok(network.heard.includes('report 12 3 1 B F0191 0'), network.heard.join('\n'));
  assert.ok(!network.heard.includes('000#010C'));
  console.log('a slave that is not there is asked for again');

  network.heard.length = 0;
  network.tell('70A#00');
  await network.runUntil(5000);
  assert.ok(network.heard.includes('report 10 2 11 - 0 0'), network.heard.join('\n'));
  assert.strictEqual(network.heard.filter((frame) => frame === '000#010A').length, 1);
  console.log('a slave that restarts is booted again');
  await network.end();
}

run(main);
