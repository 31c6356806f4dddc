'use strict';

// Lift panels of CiA 417-4 with node-canopen: first it is the call controller of a landing panel of ours, and hears its
// buttons and lights its lamps; then it is the panel of a call controller of ours, presses a button by a PDO, and sees
// the acknowledgement come and go.
//
//     node tests/strangers/lift_panel/lift_panel_test.js PEER
//
// PEER is the program of peer.cpp.

const assert = require('assert');
const {Eds, DataType} = require('canopen');
const {Stranger} = require('../stranger');
const {Wire, run} = require('../wire');

const CONTROLLER = 1;
const PANEL = 22;

// The six bytes of a record as the number that a PDO carries.
const record = (...bytes) => Buffer.from(bytes).readUIntLE(0, 6);
const UP_AT_3 = [0x02, 0x01, 0x01, 0x03, 0x10];

// It sends records in one PDO and hears them in another.
class Partner extends Stranger {
  constructor(wire, id, other, {sendCobId, hearCobId}) {
    const eds = new Eds();
    super(wire, id, other, eds);
    const entry = (index, parameterName) => eds.addEntry(index, {parameterName, dataType: DataType.UNSIGNED48});
    this.sent = entry(0x6200, 'sent record');
    this.received = entry(0x6100, 'received record');
    this.records = [];
    eds.addTransmitPdo({cobId: sendCobId, transmissionType: 254, dataObjects: [this.sent]});
    eds.addReceivePdo({cobId: hearCobId, dataObjects: [this.received]});
    this.device.pdo.on('pdo', () => this.records.push(this.received.value));
  }

  async hears(value, what) {
    await this.wire.until(what, () => this.records.includes(value));
    this.records = [];
  }
}

async function lightsOurLamps(command) {
  const wire = new Wire(command, 'panel');
  const controller = new Partner(wire, CONTROLLER, PANEL, {sendCobId: 0x400, hearCobId: 0x480 + PANEL});
  await controller.open();
  controller.start();
  assert.strictEqual(await controller.read(0x6000, 1, DataType.UNSIGNED16), 0x0200);
  assert.strictEqual(await controller.read(0x6000, 2, DataType.UNSIGNED16), 0x0300);

  wire.tell('press 0');
  await controller.hears(record(...UP_AT_3, 1), 'the call');
  assert.strictEqual(await controller.read(0x6100, 1, DataType.UNSIGNED48), record(...UP_AT_3, 1));
  controller.sent.value = record(...UP_AT_3, 1);
  await wire.until('the lamp', () => wire.heard.includes('lamp 0 on 1'));
  wire.tell('release 0');
  await controller.hears(record(...UP_AT_3, 0), 'the release');

  controller.sent.value = record(0x40, 7, 0x01, 0xFF, 0xF0, 1);
  await wire.until('floor 7', () => wire.heard.includes('lamp 3 on 7'));
  controller.sent.value = record(...UP_AT_3, 0);
  await wire.until('the lamp off', () => wire.heard.includes('lamp 0 off 1'));

  wire.tell('press 2');
  await controller.hears(record(0x0E, 0x0C, 0x01, 0x03, 0x10, 0x81), 'the key for fire service');
  await controller.write(0x6120, 2, 0xFFFFFFFE, DataType.UNSIGNED32);
  wire.tell('press 1');
  wire.tell('release 2');
  await controller.hears(record(0x0E, 0x0C, 0x01, 0x03, 0x10, 0x80), 'the key back');
  assert.ok(!wire.heard.some((line) => line.startsWith('496#0202') && line.endsWith('01')), 'it is disabled');
  const refused = await controller.refusal(0x6140, 1, 0xFFFF00FF, DataType.UNSIGNED32);
  assert.strictEqual(refused, 0x06090030, 'a limitation of 0 is reserved');
  await wire.end();
}

async function callsOurController(command) {
  const wire = new Wire(command, 'controller');
  const panel = new Partner(wire, PANEL, CONTROLLER, {sendCobId: 0x480 + PANEL, hearCobId: 0x400});
  await panel.open();
  panel.start();
  panel.sent.value = record(...UP_AT_3, 1);
  // Bit 7 of the function data says that the call is affirmed.
  await wire.until('the acknowledgement', () => panel.records.some((value) => isAnswer(value, true)));
  panel.sent.value = record(...UP_AT_3, 0);
  wire.tell('arrive 3');
  await wire.until('its end', () => panel.records.some((value) => isAnswer(value, false)));
  await wire.until('the position', () => panel.records.some((value) => {
    const bytes = bytesOf(value);
    return bytes[0] === 0x40 && bytes[1] === 3 && (bytes[5] & 1) === 1;
  }));
  await wire.end();
}

function bytesOf(value) {
  const bytes = Buffer.alloc(6);
  bytes.writeUIntLE(value, 0, 6);
  return bytes;
}

function isAnswer(value, on) {
  const bytes = bytesOf(value);
  const isMine = bytes[0] === 0x02 && bytes[1] === 0x01 && (bytes[2] & 1) !== 0 && bytes[3] === 3;
  return isMine && ((bytes[5] & 1) !== 0) === on;
}

async function main() {
  for (const step of [lightsOurLamps, callsOurController]) {
    await step(process.argv[2]);
    console.log(step.name);
  }
}

run(main);
