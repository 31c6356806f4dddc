'use strict';

// A car door of a lift (CiA 417-4) commanded by node-canopen: controlwords by PDO, statuswords and positions back,
// configuration by SDO, emergencies, and the loss of the controller's heartbeat.
//
//     node tests/strangers/doors/doors_test.js PEER
//
// PEER is the program of peer.cpp; frames go through its standard input and output.

const assert = require('assert');
const {spawn} = require('child_process');
const readline = require('readline');

const {Device, Eds, DataType} = require('canopen');

const DOOR = 6;
const TIME_OUT_MS = 30000;

const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

// Bits 15 to 12 of the controlword and of the statusword, from CiA 417-4, 4.6.1 and 4.7.1.
const CLOSE = 0x1FFF;
const OPEN = 0x4FFF;
const NO_ACTION = 0xFFFF;
const STATE = {closedWithTorque: 0, closedWithoutTorque: 1, closing: 2, openedWithTorque: 3, opening: 5, reOpening: 6, stopped: 7};

class Controller {
  constructor(command) {
    this.heard = [];
    this.peer = spawn(command, [], {stdio: ['pipe', 'pipe', 'inherit']});
    readline.createInterface({input: this.peer.stdout}).on('line', (line) => {
      this.heard.push(line);
      const [id, hex] = line.split('#');
      if (hex.startsWith('R')) return;
      const data = Buffer.from(hex, 'hex');
      setImmediate(() => this.device.receive({id: parseInt(id, 16), data, len: data.length}));
    });
    const eds = new Eds();
    eds.addSdoClientParameter(DOOR, 0x600 + DOOR, 0x580 + DOOR);
    const entry = (index) => eds.addEntry(index, {parameterName: `object ${index}`, dataType: DataType.UNSIGNED16});
    this.words = [entry(0x3300), entry(0x3301), entry(0x3302), entry(0x3303)];
    for (const word of this.words) word.value = NO_ACTION;
    this.status = entry(0x3310);
    this.position = entry(0x3311);
    eds.addTransmitPdo({cobId: 0x200, transmissionType: 254, dataObjects: this.words});
    eds.addReceivePdo({cobId: 0x201, dataObjects: [this.status, this.position]});
    this.device = new Device({id: 1, eds});
    this.device.on('message', ({id, data}) => this.send(id, data || Buffer.alloc(0)));
    this.device.start();
  }

  send(id, data) {
    const line = `${id.toString(16).toUpperCase().padStart(3, '0')}#${data.toString('hex').toUpperCase()}`;
    this.heard.push('>' + line);
    this.peer.stdin.write(line + '\n');
  }

  stand(isInTheWay) {
    this.peer.stdin.write(isInTheWay ? '+\n' : '-\n');
  }

  configure(subIndex, data) {
    return this.device.sdo.download({deviceId: DOOR, index: 0x6304, subIndex, data, dataType: DataType.UNSIGNED8, timeout: TIME_OUT_MS});
  }

  get state() {
    return this.status.value >> 12;
  }

  // Whether a statusword from there on was of this state: it may be gone again when one looks.
  told(state, from) {
    return this.heard.slice(from).some((line) => line.startsWith('201#') && parseInt(line[6], 16) === state);
  }

  async until(what, isSo) {
    const giveUp = Date.now() + TIME_OUT_MS;
    while (!isSo()) {
      assert.ok(Date.now() < giveUp, `${what} did not come; heard ${this.heard.slice(-20).join(' ')}`);
      await sleep(5);
    }
  }

  // A command that is the same as before is none: first the door hears "no action".
  command(word) {
    this.words[0].value = NO_ACTION;
    this.words[0].value = word;
  }
}

async function opensAndCloses(controller) {
  await controller.until('the first statusword', () => controller.heard.includes('201#11100000'));
  const from = controller.heard.length;
  controller.command(OPEN);
  await controller.until('an open door', () => controller.state === STATE.openedWithTorque);
  assert.strictEqual(controller.position.value, 900);
  const positions = controller.heard.slice(from).filter((line) => /^201#..5/.test(line))
    .map((line) => parseInt(line.slice(10, 12) + line.slice(8, 10), 16));
  assert.ok(positions.length >= 4, `${positions} while it opened`);
  assert.deepStrictEqual(positions, [...positions].sort((a, b) => a - b), 'it opens further and further');
  controller.command(CLOSE);
  await controller.until('a closed door', () => controller.state === STATE.closedWithTorque);
  await controller.until('a locked door with a closed contact', () => (controller.status.value & 0x33) === 0x11);
  assert.strictEqual(controller.position.value, 0);
}

async function reOpensForAPassenger(controller) {
  await controller.configure(0x04, 1);
  await controller.configure(0x08, 1);
  controller.command(OPEN);
  await controller.until('an open door', () => controller.state === STATE.openedWithTorque);
  controller.stand(true);
  await sleep(50);
  controller.stand(false);
  const from = controller.heard.length;
  controller.command(CLOSE);
  await controller.until('a closing door', () => controller.told(STATE.closing, from));
  controller.stand(true);
  await controller.until('a door that re-opens', () => controller.told(STATE.reOpening, from));
  controller.stand(false);
  await controller.until('a door that closes by itself', () => controller.state === STATE.closedWithTorque);
}

async function refusesReservedModes(controller) {
  for (const subIndex of [0x04, 0x05, 0x06, 0x07, 0x0B]) {
    const code = await controller.configure(subIndex, 3).then(() => undefined, (error) => error.code);
    assert.strictEqual(code, 0x06090030, `6304h:${subIndex.toString(16)}h`);
  }
}

async function stopsWithoutItsController(controller) {
  await controller.configure(0x0B, 1);
  controller.send(0x701, Buffer.from([5])); // a heartbeat, and no other
  controller.command(OPEN);
  await controller.until('an open door', () => controller.state === STATE.openedWithTorque);
  await controller.until('the emergency', () => controller.heard.includes('086#3081110100000000'));
  controller.send(0x701, Buffer.from([5]));
  await controller.until('the end of the error', () => controller.heard.includes('086#0000000000000000'));
  controller.command(CLOSE);
  await controller.until('a closed door', () => controller.state === STATE.closedWithTorque);
}

async function main() {
  const controller = new Controller(process.argv[2]);
  await controller.until('the boot-up message', () => controller.heard.includes('706#00'));
  controller.device.nmt.startNode(); // itself
  controller.device.nmt.startNode(DOOR);
  await opensAndCloses(controller);
  await reOpensForAPassenger(controller);
  await refusesReservedModes(controller);
  await stopsWithoutItsController(controller);
  controller.peer.stdin.end();
  controller.device.stop();
  console.log('node-canopen opens and closes a car door');
}

main().then(() => process.exit(0), (error) => {
  console.error(error);
  process.exit(1);
});
