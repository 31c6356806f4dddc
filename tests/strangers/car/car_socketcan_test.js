'use strict';

// A car on a real CAN interface, in three processes: gateway, taximeter, and an add-on device of node-canopen. Neither
// device has a node-ID: the gateway finds, names and starts both. The stranger reads the taximeter on the channel that the
// two have for themselves. candump listens, and each frame of its log has a name. (A device that comes back gets the
// node-ID that it had: cli.run_car_parts.)
//
//     node tests/strangers/car/car_socketcan_test.js COMMAND FOLDER
//
// COMMAND is canvoy; candump.log is left in FOLDER.

const assert = require('assert');
const path = require('path');
const {DataType, Device, Eds} = require('canopen');
const {CanBus, SPEAKERS} = require('../charging/can_bus');
const {assertDecodes} = require('../charging/logs');
const {Program} = require('../charging/program');

const [command, folder] = process.argv.slice(2);
const BUS = 'vcan0';
const TAXIMETER = 2; // the gateway gives the lowest that is free
const STRANGER = 3;
const IDENTITY = {vendorId: 0x2F0, productCode: 0x1A3, revisionNumber: 0x80010002, serialNumber: 77};
const TIME_OUT_MS = 60000;
const LSS_REQUEST = 0x7E5;
// Client 3, server 2: 240h + 20h + 1, and 80h less.
const REQUEST = 0x261;
const RESPONSE = 0x1E1;

const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

async function listen() {
  const bus = new CanBus(BUS, path.join(folder, 'candump.log'));
  // candump hears nothing until its socket is open.
  for (let tries = 0; tries < 100 && bus.heard.length === 0; ++tries) {
    bus.throwIn('7FF#');
    await sleep(200);
  }
  return bus;
}

function startTaximeter() {
  return new Program(SPEAKERS, command, 'device', 'taximeter', BUS, '--node-id', 'lss', '--serial-number', '2');
}

async function comesUp(bus, node, start) {
  const state = (name, byte) =>
    bus.until(`node ${node} ${name}`, (frame) => frame.id === 0x700 + node && frame.data[0] === byte);
  const up = [state('boots up', 0), state('operational', 5)];
  const program = start();
  await Promise.all(up);
  return program;
}

// node-canopen answers Fastscan with a node-ID, too, which CiA 305 leaves to those without. The gateway bears with it
// (LssScan), but each of its looks around takes half a minute here: too long for this test.
function isAnsweredWrongly(frame, device) {
  return frame.id === LSS_REQUEST && device.id === STRANGER;
}

function stranger(bus) {
  const eds = new Eds();
  eds.setIdentity(IDENTITY);
  eds.setHeartbeatProducerTime(500); // it sends no boot-up message, but heartbeats
  eds.addSdoClientParameter(TAXIMETER, REQUEST, RESPONSE);
  const device = new Device({eds, enableLss: true});
  device.on('message', ({id, data}) => bus.send(id, data || Buffer.alloc(0)));
  bus.on('frame', (frame) => {
    if (frame.id === null || frame.remote || isAnsweredWrongly(frame, device)) return;
    setImmediate(() => device.receive({id: frame.id, data: frame.data, len: frame.data.length}));
  });
  return device;
}

async function joins(device) {
  const giveUp = Date.now() + 90000;
  while (device.id !== STRANGER) {
    assert.ok(Date.now() < giveUp, `its node-ID is ${device.id}`);
    await sleep(50);
  }
  device.start();
  while (device.nmt.state !== 5) {
    assert.ok(Date.now() < giveUp, `its state is ${device.nmt.state}`);
    await sleep(50);
  }
}

async function readsTheTaximeter(device) {
  const state = await device.sdo.upload({
    deviceId: TAXIMETER, index: 0x60D8, subIndex: 0, dataType: DataType.UNSIGNED8, timeout: TIME_OUT_MS,
  });
  // Signed off is 3; "changing to off mode" is no (0); reserved bits are 1 (4.2.12.6).
  assert.strictEqual(state, 0xC3);
}

const SERVICES = ['NMT', 'PDO', 'LSS', 'SDO request', 'SDO response', 'heartbeat', 'boot-up', 'sleep'];

async function main() {
  const bus = await listen();
  const gateway = await comesUp(bus, 1, () => new Program(SPEAKERS, command, 'device', 'ivn-gateway', BUS));
  const taximeter = await comesUp(bus, TAXIMETER, startTaximeter);
  console.log('the taximeter has its node-ID, and is operational');

  const device = stranger(bus);
  await joins(device);
  await readsTheTaximeter(device);
  console.log('node-canopen has joined, and reads it');

  device.stop();
  await taximeter.end();
  await gateway.end();
  bus.close();
  const frames = assertDecodes(command, path.join(folder, 'candump.log'), '447-3', SERVICES);
  console.log(`${frames} frames of candump have a name`);
}

main().then(() => process.exit(0), (error) => {
  console.error(error);
  process.exit(1);
});
