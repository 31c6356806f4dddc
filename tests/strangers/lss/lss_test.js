'use strict';

// node-canopen as LSS master of three nodes of ours that have no node-ID: Fastscan, and the services for one node.
//
//     node tests/strangers/lss/lss_test.js PEER LOG
//
// PEER is the program of peer.cpp. LOG gets all frames as candump writes them, for tshark.

const assert = require('assert');
const fs = require('fs');
const {Device, Eds} = require('canopen');
const {Wire, frameText, run} = require('../wire');

const [peerPath, logPath] = process.argv.slice(2);
const SERIALS = [0x80000001, 0x80000003, 77];
const KIND = {vendorId: 0x2F0, productCode: 0x1A3, revisionNumber: 0x80010002};
const SILENCE = 199; // ms; see silenceIsAnAnswer()
const PATIENCE = 30000;
const OPERATION = 0;
const CONFIGURATION = 1;

class Network extends Wire {
  constructor() {
    super(peerPath, ...SERIALS.map(String));
    this.log = fs.openSync(logPath, 'w');
    this.device = new Device({id: 1, eds: new Eds(), enableLss: true});
    this.connect(this.device);
    this.device.start();
  }

  note(line) {
    fs.writeSync(this.log, `(${(Date.now() / 1000).toFixed(6)}) can0 ${line}\n`);
  }

  send(id, data) {
    this.note(frameText(id, data));
    super.send(id, data);
  }

  hear(line) {
    if (!line.startsWith('now ')) this.note(line);
    super.hear(line);
  }
}

// To Fastscan silence says as much as an answer, and node-canopen takes a time-out for it. It is over when our nodes
// have said what they had to say, however long a busy machine takes for that.
function silenceIsAnAnswer(network) {
  const {setTimeout, clearTimeout} = global;
  const waiting = new Set();
  global.setTimeout = (callback, ms, ...more) => {
    if (ms !== SILENCE) return setTimeout(callback, ms, ...more);
    const timer = {};
    waiting.add(timer);
    // The message of which the answer is waited for is sent in this turn.
    setImmediate(() => network.step().then(() => waiting.delete(timer) && callback()));
    return timer;
  };
  global.clearTimeout = (timer) => {
    if (!waiting.delete(timer)) clearTimeout(timer);
  };
}

// Fastscan finds the one of which the first bit that differs is zero.
async function findsAllByFastscan(network) {
  const {device, heard} = network;
  const found = [];
  for (let id = 10; ; ++id) {
    const identity = await device.lss.fastscan({timeout: SILENCE});
    if (identity === null) break;
    const {serialNumber, ...kind} = identity;
    assert.deepStrictEqual(kind, KIND);
    found.push(serialNumber);
    await device.lss.configureNodeId(id, PATIENCE);
    assert.ok(!heard.includes(`7${id.toString(16).toUpperCase().padStart(2, '0')}#00`), 'it boots too early');
    device.lss.switchModeGlobal(OPERATION);
    await network.hears(`7${id.toString(16).toUpperCase().padStart(2, '0')}#00`);
  }
  assert.deepStrictEqual(found, [77, 0x80000001, 0x80000003]);
}

async function findsNothingMore({device}) {
  assert.strictEqual(await device.lss.fastscan({timeout: SILENCE}), null);
}

async function configuresOneThatItSelects(network) {
  const {device} = network;
  const {lss} = device;
  await lss.switchModeSelective({...KIND, serialNumber: 77, timeout: PATIENCE});
  assert.strictEqual(await lss.inquireVendorId(PATIENCE), KIND.vendorId);
  assert.strictEqual(await lss.inquireProductCode(PATIENCE), KIND.productCode);
  assert.strictEqual(await lss.inquireRevisionNumber(PATIENCE), KIND.revisionNumber);
  assert.strictEqual(await lss.inquireSerialNumber(PATIENCE), 77);
  await assert.rejects(lss.configureNodeId(0, PATIENCE), {code: 1});
  await assert.rejects(lss.configureBitTiming(0, 2, PATIENCE), {code: 1});
  await lss.configureNodeId(20, PATIENCE);
  await lss.storeConfiguration(PATIENCE);
  lss.switchModeGlobal(OPERATION);
  device.nmt.resetNode(10);
  await network.hears('714#00');
}

async function getsNoAnswerOfAnotherAddress({device}) {
  await assert.rejects(device.lss.switchModeSelective({...KIND, serialNumber: 78, timeout: SILENCE}));
  device.lss.switchModeGlobal(CONFIGURATION);
  device.lss.switchModeGlobal(OPERATION);
}

async function main() {
  const network = new Network();
  silenceIsAnAnswer(network);
  for (const test of [findsAllByFastscan, findsNothingMore, configuresOneThatItSelects, getsNoAnswerOfAnotherAddress]) {
    await test(network);
    console.log(`${test.name} passed`);
  }
  network.device.stop();
  await network.end();
}

run(main);
