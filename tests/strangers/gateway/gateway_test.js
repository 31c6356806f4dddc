'use strict';

// A node of node-canopen behind our gateway: objects, NMT, emergencies, heartbeats and process data.
//
//     node tests/strangers/gateway/gateway_test.js PEER
//
// PEER is the program of peer.cpp; frames and lines go through its standard input and output.

const assert = require('assert');
const {AccessType, DataType, Device, Eds, NmtState} = require('canopen');
const {Wire, run} = require('../wire');

const NODE = 2;
const LONG_TEXT = 'a visible string of node-canopen that needs a few segments';

class World extends Wire {
  constructor(peer) {
    super(peer);
    const eds = new Eds();
    const entry = (index, dataType, defaultValue) => eds.addEntry(index,
      {parameterName: `object ${index}`, dataType, defaultValue, accessType: AccessType.READ_WRITE});
    this.level = entry(0x2000, DataType.UNSIGNED16, 500);
    entry(0x2001, DataType.INTEGER32, -5);
    entry(0x2002, DataType.VISIBLE_STRING, LONG_TEXT);
    entry(0x2003, DataType.REAL32, 1.5);
    eds.addSdoServerParameter(0, 0x580 + NODE, 0x600 + NODE);
    eds.setEmcyCobId(0x80 + NODE);
    eds.setHeartbeatProducerTime(50);
    eds.addTransmitPdo({cobId: 0x180 + NODE, transmissionType: 254, dataObjects: [this.level]});
    this.device = new Device({id: NODE, eds});
    this.told = []; // lines for the client
    this.connect(this.device);
  }

  hear(line) {
    if (!line.startsWith('<')) return super.hear(line);
    return this.told.push(line.slice(1));
  }

  async ask(sequence, command) {
    this.tell(`>[${sequence}] ${command}`);
    const isAnswer = (line) => line.startsWith(`[${sequence}] `);
    await this.until(`an answer to ${command}`, () => this.told.some(isAnswer));
    const answer = this.told.find(isAnswer).slice(`[${sequence}] `.length);
    this.told = this.told.filter((line) => !isAnswer(line));
    return answer;
  }

  async hearsOf(event) {
    await this.until(event, () => this.told.includes(event));
    this.told = this.told.filter((line) => line !== event);
  }
}

async function readsAndWritesObjects(world) {
  assert.strictEqual(await world.ask(1, '2 r 0x2000 0 u16'), '500');
  assert.strictEqual(await world.ask(2, '2 r 0x2001 0 i32'), '-5');
  assert.strictEqual(await world.ask(3, '2 r 0x2003 0 r32'), '1.5');
  assert.strictEqual(await world.ask(4, '2 w 0x2001 0 i32 -123456'), 'OK');
  assert.strictEqual(world.device.getValue(0x2001), -123456);
  assert.strictEqual(await world.ask(5, '2 r 0x2001 0 i32'), '-123456');
}

async function readsAndWritesInSegments(world) {
  assert.strictEqual(await world.ask(1, '2 r 0x2002 0 vs'), `"${LONG_TEXT}"`);
  assert.strictEqual(await world.ask(2, '2 w 0x2002 0 vs "Hello, ""World""!"'), 'OK');
  assert.strictEqual(world.device.getValue(0x2002), 'Hello, "World"!');
}

// In one direction: block uploads from node-canopen 6.2.1 end in an exception of its own, past the end of the value.
async function writesInBlocks(world) {
  const text = LONG_TEXT.repeat(20);
  assert.strictEqual(await world.ask(1, 'set sdo_block 1'), 'OK');
  assert.strictEqual(await world.ask(2, `2 w 0x2002 0 vs "${text}"`), 'OK');
  assert.strictEqual(world.device.getValue(0x2002), text);
  assert.strictEqual(await world.ask(3, 'set sdo_block 0'), 'OK');
  assert.strictEqual(await world.ask(4, '2 r 0x2002 0 vs'), `"${text}"`);
}

async function quotesTheAbortOfTheServer(world) {
  assert.strictEqual(await world.ask(1, '2 r 0x5000 0 u8'), 'ERROR:0x06020000');
}

async function startsTheNode(world) {
  assert.strictEqual(await world.ask(1, '2 start'), 'OK');
  await world.until('NMT state operational', () => world.device.nmt.state === NmtState.OPERATIONAL);
}

async function hearsProcessData(world) {
  assert.strictEqual(await world.ask(1, 'set rpdo 1 0x182 event 1 0x2000 0 u16'), 'OK');
  world.device.setValue(0x2000, 0x1234);
  await world.hearsOf('1 pdo 1 1 0x1234');
  assert.strictEqual(await world.ask(2, 'r p 1'), '1 pdo 1 1 0x1234');
}

async function hearsAnEmergency(world) {
  world.device.emcy.write(0x4210, Buffer.from([1, 2, 3, 4, 5]));
  await world.until('the emergency', () => world.told.some((line) => /^1 2 EMCY 4210 .. 1 2 3 4 5$/.test(line)));
}

async function watchesTheHeartbeat(world) {
  assert.strictEqual(await world.ask(1, '2 enable heartbeat 1000'), 'OK');
  await world.hearsOf('1 2 ERROR 202');
  world.device.stop();
  await world.hearsOf('1 2 ERROR 203');
}

async function main() {
  const world = new World(process.argv[2]);
  world.device.start();
  const tests = [readsAndWritesObjects, readsAndWritesInSegments, writesInBlocks, quotesTheAbortOfTheServer,
    startsTheNode, hearsProcessData, hearsAnEmergency, watchesTheHeartbeat];
  for (const test of tests) {
    await test(world);
    console.log(`${test.name} passed`);
  }
  await world.end();
}

run(main);
