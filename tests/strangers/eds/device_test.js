'use strict';

// node-canopen loads the data sheet of a device, and reads by it the device that `canvoy device` runs from that sheet:
// all that may be read, with its type, and that what may not be read is refused. They meet on UDP multicast as python-can
// has it.

const assert = require('assert');
const {spawn, spawnSync} = require('child_process');
const dgram = require('dgram');
const fs = require('fs');
const os = require('os');
const path = require('path');

const {AccessType, DataType, Device, Eds} = require('canopen');

const GROUP = '239.74.163.2';
const PORT = 43113;
const NODE = 5;
const TIME_OUT_MS = 30000;
const WRITE_ONLY = 0x06010001; // abort codes of CiA 301
const NO_DATA = 0x08000024;
const ERROR_HISTORY = 0x1003;
const FIRST_OF_PROFILE = 0x6000;

const command = process.argv[2];
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'canvoy-eds-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true}));

// A frame as one msgpack map: what a receiver has to know of a data frame.
function pack(id, data) {
  const key = (name) => Buffer.concat([Buffer.from([0xa0 | name.length]), Buffer.from(name)]);
  return Buffer.concat([
    Buffer.from([0x84]), key('arbitration_id'), Buffer.from([0xcd, id >> 8, id & 0xff]),
    key('is_extended_id'), Buffer.from([0xc2]), key('dlc'), Buffer.from([data.length]),
    key('data'), Buffer.from([0xc4, data.length]), data]);
}

// CAN-ID and data of a frame, which stand behind their keys.
function unpack(datagram) {
  const at = datagram.indexOf('arbitration_id') + 'arbitration_id'.length;
  const id = datagram[at] === 0xcd ? datagram.readUInt16BE(at + 1) : datagram[at + (datagram[at] === 0xcc ? 1 : 0)];
  const bytes = datagram.indexOf(Buffer.from([0xa4, 0x64, 0x61, 0x74, 0x61, 0xc4])) + 6; // "data", in binary
  return {id, data: datagram.subarray(bytes + 1, bytes + 1 + datagram[bytes])};
}

async function openBus() {
  const socket = dgram.createSocket({type: 'udp4', reuseAddr: true});
  await new Promise((resolve) => socket.bind(PORT, resolve));
  socket.setMulticastLoopback(true);
  socket.addMembership(GROUP, '127.0.0.1');
  socket.setMulticastInterface('127.0.0.1');
  return socket;
}

function exportSheet(device, name) {
  const file = path.join(folder, name);
  const {status, stderr} = spawnSync(command, ['eds', 'export', ...device, '--out', file], {encoding: 'utf8'});
  assert.strictEqual(status, 0, stderr);
  return file;
}

// All entries that have a value: variables, and the elements of arrays and records.
function* entriesOf(eds) {
  for (const object of eds.values()) {
    if (!object.subNumber) yield [object.index, 0, object];
    for (let sub = 0; object.subNumber && sub < 256; sub++) {
      const entry = object.at(sub);
      if (entry) yield [object.index, sub, entry];
    }
  }
}

// How many entries were read.
async function readAll(sdo, eds) {
  let count = 0;
  for (const [index, subIndex, entry] of entriesOf(eds)) {
    const what = `${index.toString(16)}h:${subIndex} ${entry.parameterName}`;
    const request = {deviceId: NODE, index, subIndex, dataType: entry.dataType, timeout: TIME_OUT_MS};
    const error = await sdo.upload(request).then((value) => check(what, entry, value), (reason) => reason);
    if (entry.accessType === AccessType.WRITE_ONLY) {
      assert.strictEqual(error?.code, WRITE_ONLY, what);
    } else {
      const mayHaveNone = index === ERROR_HISTORY || entry.dataType === DataType.DOMAIN;
      assert.ok(!error || error.code === NO_DATA && mayHaveNone, `${what}: ${error}`);
      count += error ? 0 : 1;
    }
  }
  return count;
}

// What the sheet says is what the device has, as far as it is a number of the profile; node-canopen counts elements
// (sub-index 00h) itself.
function check(what, entry, value) {
  const isCount = entry.parent !== undefined && entry.subIndex === 0;
  const text = entry.defaultValue ?? '';
  if (entry.index < FIRST_OF_PROFILE || isCount || !/^(0x)?[0-9A-Fa-f]+$/.test(text)) return;
  if (typeof value === 'number') assert.strictEqual(value, entry.value, what);
}

async function readDevice(name, ...device) {
  const file = exportSheet(device, `${name}.eds`);
  const eds = Eds.fromFile(file);
  const socket = await openBus();
  const ours = spawn(command, ['device', file, `udp:${GROUP}:${PORT}`, '--node-id', `${NODE}`],
    {stdio: ['ignore', 'ignore', 'inherit']});
  const master = new Eds();
  master.addSdoClientParameter(NODE, 0x600 + NODE, 0x580 + NODE);
  const client = new Device({id: 1, eds: master});
  client.on('message', ({id, data}) => socket.send(pack(id, data), PORT, GROUP));
  const booted = new Promise((resolve) => socket.on('message', (datagram) => {
    const {id, data} = unpack(datagram);
    if (id === 0x700 + NODE) resolve();
    setImmediate(() => client.receive({id, data, len: data.length}));
  }));
  await booted;
  client.start();
  const count = await readAll(client.sdo, eds);
  ours.kill();
  socket.close();
  console.log(`${name}: ${count} entries read`);
  assert.ok(count > 10, name);
}

async function main() {
  await readDevice('charger', 'charger');
  await readDevice('indicator', '407', '--device', '03', '--class', '1', '--subclass', '2', '--optional');
  await readDevice('computer', '407', '--device', '01', '--optional');
  await readDevice('door', '417-4', '--device', '05', '--optional');
  await readDevice('panel', '417-4', '--device', '02');
  await readDevice('gateway', '447-3', '--device', '00', '--optional');
  await readDevice('joystick', '852', '--device', '01', '--optional');
}

main().then(() => process.exit(0), (error) => {
  console.error(error);
  process.exit(1);
});
