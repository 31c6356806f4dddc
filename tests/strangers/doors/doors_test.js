'use strict';

// A car door of a lift (CiA 417-4) commanded by node-canopen: controlwords by PDO, statuswords and positions back,
// configuration by SDO, emergencies, and the loss of the controller's heartbeat.
//
//     node tests/strangers/doors/doors_test.js PEER
//
// PEER is the program of peer.cpp.

const assert = require('assert');
const {Eds, DataType} = require('canopen');
const {Stranger} = require('../stranger');
const {Wire, run} = require('../wire');

const DOOR = 6;

// Bits 15 to 12 of the controlword and of the statusword, from CiA 417-4, 4.6.1 and 4.7.1.
const CLOSE = 0x1FFF;
const OPEN = 0x4FFF;
const NO_ACTION = 0xFFFF;
const STATE = {closedWithTorque: 0, closedWithoutTorque: 1, closing: 2, openedWithTorque: 3, opening: 5, reOpening: 6, stopped: 7};

class Controller extends Stranger {
  constructor(wire) {
    const eds = new Eds();
    super(wire, 1, DOOR, eds);
    const entry = (index) => eds.addEntry(index, {parameterName: `object ${index}`, dataType: DataType.UNSIGNED16});
    this.words = [entry(0x3300), entry(0x3301), entry(0x3302), entry(0x3303)];
    for (const word of this.words) word.value = NO_ACTION;
    this.status = entry(0x3310);
    this.position = entry(0x3311);
    eds.addTransmitPdo({cobId: 0x200, transmissionType: 254, dataObjects: this.words});
    eds.addReceivePdo({cobId: 0x201, dataObjects: [this.status, this.position]});
  }

  stand(isInTheWay) {
    this.wire.tell(isInTheWay ? '+' : '-');
  }

  configure(subIndex, data) {
    return this.refusal(0x6304, subIndex, data, DataType.UNSIGNED8);
  }

  get state() {
    return this.status.value >> 12;
  }

  // Whether a statusword from there on was of this state: it may be gone again when one looks.
  told(state, from) {
    return this.wire.heard.slice(from).some((line) => line.startsWith('201#') && parseInt(line[6], 16) === state);
  }

  // A command that is the same as before is none: first the door hears "no action".
  command(word) {
    this.words[0].value = NO_ACTION;
    this.words[0].value = word;
  }
}

async function opensAndCloses(controller) {
  await controller.wire.until('the first statusword', () => controller.wire.heard.includes('201#11100000'));
  const from = controller.wire.heard.length;
  controller.command(OPEN);
  await controller.wire.until('an open door', () => controller.state === STATE.openedWithTorque);
  assert.strictEqual(controller.position.value, 900);
  const positions = controller.wire.heard.slice(from).filter((line) => /^201#..5/.test(line))
    .map((line) => parseInt(line.slice(10, 12) + line.slice(8, 10), 16));
  assert.ok(positions.length >= 4, `${positions} while it opened`);
  assert.deepStrictEqual(positions, [...positions].sort((a, b) => a - b), 'it opens further and further');
  controller.command(CLOSE);
  await controller.wire.until('a closed door', () => controller.state === STATE.closedWithTorque);
  await controller.wire.until('a locked door with a closed contact', () => (controller.status.value & 0x33) === 0x11);
  assert.strictEqual(controller.position.value, 0);
}

async function reOpensForAPassenger(controller) {
  assert.strictEqual(await controller.configure(0x04, 1), 0);
  assert.strictEqual(await controller.configure(0x08, 1), 0);
  controller.command(OPEN);
  await controller.wire.until('an open door', () => controller.state === STATE.openedWithTorque);
  controller.stand(true);
  await controller.wire.pass(50);
  controller.stand(false);
  const from = controller.wire.heard.length;
  controller.command(CLOSE);
  await controller.wire.until('a closing door', () => controller.told(STATE.closing, from));
  controller.stand(true);
  await controller.wire.until('a door that re-opens', () => controller.told(STATE.reOpening, from));
  controller.stand(false);
  await controller.wire.until('a door that closes by itself', () => controller.state === STATE.closedWithTorque);
}

async function refusesReservedModes(controller) {
  for (const subIndex of [0x04, 0x05, 0x06, 0x07, 0x0B]) {
    assert.strictEqual(await controller.configure(subIndex, 3), 0x06090030, `6304h:${subIndex.toString(16)}h`);
  }
}

async function stopsWithoutItsController(controller) {
  assert.strictEqual(await controller.configure(0x0B, 1), 0);
  controller.wire.send(0x701, Buffer.from([5])); // a heartbeat, and no other
  controller.command(OPEN);
  await controller.wire.until('an open door', () => controller.state === STATE.openedWithTorque);
  await controller.wire.until('the emergency', () => controller.wire.heard.includes('086#3081110100000000'));
  controller.wire.send(0x701, Buffer.from([5]));
  await controller.wire.until('the end of the error', () => controller.wire.heard.includes('086#0000000000000000'));
  controller.command(CLOSE);
  await controller.wire.until('a closed door', () => controller.state === STATE.closedWithTorque);
}

async function main() {
  const wire = new Wire(process.argv[2]);
  const controller = new Controller(wire);
  await controller.open();
  controller.start();
  await opensAndCloses(controller);
  await reOpensForAPassenger(controller);
  await refusesReservedModes(controller);
  await stopsWithoutItsController(controller);
  await wire.end();
  console.log('node-canopen opens and closes a car door');
}

run(main);
