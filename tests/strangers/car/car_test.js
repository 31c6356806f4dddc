'use strict';

// An add-on device of node-canopen in a car of ours: it has no node-ID, is found by Fastscan, named and started by the
// gateway, and reads the taximeter on the SDO channel that the two have for themselves.
//
//     node tests/strangers/car/car_test.js PEER

const assert = require('assert');
const {DataType, Device, Eds} = require('canopen');
const {Wire, run} = require('../wire');

const IDENTITY = {vendorId: 0x2F0, productCode: 0x1A3, revisionNumber: 0x80010002, serialNumber: 77};
const TIME_OUT_MS = 30000;
const GATEWAY = 1;
const FIRST_ADD_ON = 2;
// Client 2, server 1: 240h + 10h, and 80h less.
const REQUEST = 0x250;
const RESPONSE = 0x1D0;

async function isNamedByTheGateway(wire, device) {
  await wire.until('a node-ID', () => device.id === FIRST_ADD_ON);
  assert.ok(wire.heard.includes(`7E5#11${'02'}000000000000`), 'configure node-ID (CiA 305)');
}

async function isStartedByTheGateway(wire, device) {
  device.start();
  await wire.hears('000#0102');
  await wire.until('operational', () => device.nmt.state === 5);
}

async function readsTheTaximeterOnTheirOwnChannel(wire, device) {
  const read = (index) => device.sdo.upload({
    deviceId: GATEWAY, index, subIndex: 0, dataType: DataType.UNSIGNED8, timeout: TIME_OUT_MS,
  });
  const answer = async (index) => {
    const value = read(index);
    await wire.pass(50);
    return value;
  };
  // Signed off is 3; "changing to off mode" is no (0); reserved bits are 1 (4.2.12.6).
  assert.strictEqual(await answer(0x60D8), 0xC3);
  wire.tell('on');
  await wire.pass(50);
  assert.strictEqual(await answer(0x60D8), 0xC0); // for hire
  assert.ok(wire.heard.includes('>250#40D8600000000000'));
  assert.ok(wire.heard.includes('1D0#4FD86000C0000000'));
}

async function main() {
  const [peer] = process.argv.slice(2);
  const wire = new Wire(peer);
  const eds = new Eds();
  eds.setIdentity(IDENTITY);
  eds.setHeartbeatProducerTime(500); // it sends no boot-up message, but heartbeats
  eds.addSdoClientParameter(GATEWAY, REQUEST, RESPONSE);
  const device = new Device({eds, enableLss: true});
  wire.connect(device);
  for (const test of [isNamedByTheGateway, isStartedByTheGateway, readsTheTaximeterOnTheirOwnChannel]) {
    await test(wire, device);
    console.log(`${test.name} passed`);
  }
  device.stop();
  await wire.end();
}

run(main);
