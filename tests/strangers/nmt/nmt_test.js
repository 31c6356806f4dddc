'use strict';

// node-canopen as NMT master of a node of ours, and the heartbeats of both: states, a loss and a return, each way.
//
//     node tests/strangers/nmt/nmt_test.js PEER
//
// PEER is the program of peer.cpp.

const assert = require('assert');
const {DataType, Eds, NmtState} = require('canopen');
const {Stranger} = require('../stranger');
const {Wire, run} = require('../wire');

const NODE = 5;
const LOST = '085#3081110100000000'; // 8130h, communication error; the node-ID stands in the manufacturer's field
const BACK = '085#0000000000000000';

class Master extends Stranger {
  constructor(wire) {
    const eds = new Eds();
    eds.addHeartbeatConsumer(NODE, 500);
    super(wire, 1, NODE, eds);
    this.eds = eds;
    this.states = []; // of our node, as its heartbeats tell
    this.losses = 0;
    this.device.nmt.on('heartbeat', ({state}) => this.states.push(state));
    this.device.nmt.on('timeout', () => ++this.losses);
  }

  async hears(state) {
    await this.wire.until(`state ${state}`, () => this.states.at(-1) === state);
  }
}

async function commandsOurNode(master) {
  const {nmt} = master.device;
  await master.write(0x1017, 0, 100, DataType.UNSIGNED16);
  await master.hears(NmtState.PRE_OPERATIONAL);
  nmt.startNode(NODE);
  await master.hears(NmtState.OPERATIONAL);
  nmt.stopNode(NODE);
  await master.hears(NmtState.STOPPED);
  nmt.enterPreOperational(NODE);
  await master.hears(NmtState.PRE_OPERATIONAL);
  nmt.startNode(NODE + 1);
  await master.wire.pass(300);
  assert.strictEqual(master.states.at(-1), NmtState.PRE_OPERATIONAL, 'the command was for another node');
}

// The heartbeat has its default, which is none, again.
async function resetsOurNode(master) {
  for (const reset of ['resetNode', 'resetCommunication']) {
    const from = master.wire.heard.length;
    master.device.nmt[reset](NODE);
    await master.wire.hears('705#00', from);
    assert.strictEqual(await master.read(0x1017, 0, DataType.UNSIGNED16), 0);
    await master.write(0x1017, 0, 100, DataType.UNSIGNED16);
    await master.hears(NmtState.PRE_OPERATIONAL);
  }
}

// Our node's time stands still while nobody waits for it.
async function losesOurNodeAndFindsItAgain(master) {
  const {losses} = master;
  const lost = new Promise((resolve) => master.device.nmt.once('timeout', resolve));
  assert.strictEqual(await lost, NODE);
  assert.ok(master.losses > losses);
  master.states.length = 0;
  await master.hears(NmtState.PRE_OPERATIONAL);
}

async function isLostAndFoundByOurNode(master) {
  master.eds.setHeartbeatProducerTime(50);
  await master.wire.until('a heartbeat', () => master.wire.heard.includes('>701#7F'));
  await master.wire.pass(3000);
  assert.ok(!master.wire.heard.includes(LOST), 'it was heard in time');
  master.eds.setHeartbeatProducerTime(0);
  await master.wire.hears(LOST);
  master.eds.setHeartbeatProducerTime(50);
  await master.wire.hears(BACK);
}

async function main() {
  const wire = new Wire(process.argv[2]);
  const master = new Master(wire);
  await master.open();
  for (const step of [commandsOurNode, resetsOurNode, losesOurNodeAndFindsItAgain, isLostAndFoundByOurNode]) {
    await step(master);
    console.log(step.name);
  }
  await wire.end();
}

run(main);
