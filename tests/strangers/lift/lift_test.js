'use strict';

// A lift on a real CAN interface, in four processes: the drive, the position unit, the controller with doors and all else,
// and node-canopen, which is the panel of the third floor: it presses a button by a PDO, sees the acknowledgement, and
// the car come. candump listens.
//
//     node tests/strangers/lift/lift_test.js COMMAND FOLDER
//
// COMMAND is canvoy; candump.log is left in FOLDER.

const assert = require('assert');
const path = require('path');
const {Device, Eds, DataType} = require('canopen');
const {CanBus, SPEAKERS} = require('../charging/can_bus');
const {Program} = require('../charging/program');

const [command, folder] = process.argv.slice(2);
const BUS = 'vcan0';
const PANEL = 23;
const DOWN_AT_3 = [0x02, 0x02, 0x01, 0x03, 0x10]; // a standard hall call (CiA 417-4, 4.3.1)
const FLOOR_3 = 70000; // 7 m in the position unit's steps of 0.1 mm
const WITHIN = 100; // 10 mm

const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
const bytesOf = (record) => {
  const bytes = Buffer.alloc(6);
  bytes.writeUIntLE(record, 0, 6);
  return bytes;
};

// A landing panel: what it presses goes out by 480h + node-ID, what it is to show comes by 400h.
class Panel {
  constructor(bus) {
    const eds = new Eds();
    const entry = (index) => eds.addEntry(index, {parameterName: `record ${index}`, dataType: DataType.UNSIGNED48});
    this.sent = entry(0x6200);
    this.shown = entry(0x6100);
    this.records = [];
    eds.addTransmitPdo({cobId: 0x480 + PANEL, transmissionType: 254, dataObjects: [this.sent]});
    eds.addReceivePdo({cobId: 0x400, dataObjects: [this.shown]});
    this.device = new Device({id: PANEL, eds});
    this.device.on('message', ({id, data}) => bus.send(id, data || Buffer.alloc(0)));
    bus.on('frame', (frame) => {
      if (frame.id === null || frame.remote) return;
      setImmediate(() => this.device.receive({id: frame.id, data: frame.data, len: frame.data.length}));
    });
    this.device.pdo.on('pdo', () => this.records.push(bytesOf(this.shown.value)));
    this.device.start();
    this.device.nmt.startNode();
  }

  press(pressed) {
    this.sent.value = Buffer.from([...DOWN_AT_3, pressed ? 1 : 0]).readUIntLE(0, 6);
  }

  // The lamp of the button: bit 0 of the function data (4.4.1).
  async seesLamp(on) {
    const isMine = (bytes) => DOWN_AT_3.slice(0, 2).every((byte, i) => byte === bytes[i]) && bytes[3] === 3;
    const giveUp = Date.now() + 90000;
    while (!this.records.some((bytes) => isMine(bytes) && ((bytes[5] & 1) === 1) === on)) {
      assert.ok(Date.now() < giveUp, `the lamp did not go ${on ? 'on' : 'off'}`);
      await sleep(20);
    }
    this.records = [];
  }
}

async function listen() {
  const bus = new CanBus(BUS, path.join(folder, 'candump.log'));
  // candump hears nothing until its socket is open.
  for (let tries = 0; tries < 100 && bus.heard.length === 0; ++tries) {
    bus.throwIn('7FF#');
    await sleep(200);
  }
  return bus;
}

async function startLift(bus) {
  const boots = (node) => bus.until(`the boot-up of node ${node}`,
    (frame) => frame.id === 0x700 + node && frame.data[0] === 0);
  const units = Promise.all([boots(2), boots(4)]);
  const drive = new Program(SPEAKERS, command, 'device', 'lift-drive', BUS);
  const position = new Program(SPEAKERS, command, 'device', 'lift-position', BUS);
  await units;
  const operational = [1, 2, 4, 6].map((node) => bus.until(`node ${node} operational`,
    (frame) => frame.id === 0x700 + node && frame.data[0] === 5));
  const rest = new Program(SPEAKERS, command, 'run', path.join(__dirname, 'house.toml'));
  await Promise.all(operational);
  return [drive, position, rest];
}

async function main() {
  const bus = await listen();
  const programs = await startLift(bus);
  const panel = new Panel(bus);

  const comes = bus.until('the car at floor 3', ({id, data}) =>
    id === 0x18C && data.length >= 4 && Math.abs(data.readInt32LE(0) - FLOOR_3) <= WITHIN, 300);
  const opens = bus.until('the doors open', ({id, data}) => id === 0x201 && data.length >= 4 && data.readUInt16LE(2) > 0, 300);
  panel.press(true);
  await panel.seesLamp(true);
  panel.press(false);
  console.log('the call is acknowledged');
  await comes;
  console.log('the car has come');
  await opens;
  await panel.seesLamp(false);
  console.log('its doors open, and the call is served');

  const [drive, position, rest] = programs;
  await rest.says(/lift 1 is open at floor 3/, {seconds: 300}); // fully: some seconds behind the first position
  // Where the car is while it moves, the rest knows as well as an emulated machine keeps time: its referee is no judge.
  rest.child.kill('SIGTERM');
  await rest.status;
  assert.ok(!/lift 1 is open at floor [12]/.test(rest.out), rest.out);
  await position.end();
  await drive.end();
  bus.close();
}

main().then(() => process.exit(0), (error) => {
  console.error(error);
  process.exit(1);
});
