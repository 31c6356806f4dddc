'use strict';

// node-canopen as LSS master of three nodes of ours that have no node-ID: Fastscan, and the services for one node.
//
//     node tests/strangers/lss/lss_test.js PEER LOG
//
// PEER is the program of peer.cpp; frames go through its standard input and output. LOG gets all of them as candump
// writes them, for tshark.

const assert = require('assert');
const fs = require('fs');
const {spawn} = require('child_process');
const readline = require('readline');

const {Device, Eds} = require('canopen');

const [peerPath, logPath] = process.argv.slice(2);
const SERIALS = [0x80000001, 0x80000003, 77];
const KIND = {vendorId: 0x2F0, productCode: 0x1A3, revisionNumber: 0x80010002};
const TIMEOUT = 200; // ms: silence means a one, so it must be longer than a pipe and a busy machine take
const PATIENCE = 30000;
const OPERATION = 0;
const CONFIGURATION = 1;

class Network {
  constructor() {
    this.device = new Device({id: 1, eds: new Eds(), enableLss: true});
    this.peer = spawn(peerPath, SERIALS.map(String), {stdio: ['pipe', 'pipe', 'inherit']});
    this.log = fs.openSync(logPath, 'w');
    this.frames = [];
    this.waiting = [];
    readline.createInterface({input: this.peer.stdout}).on('line', (line) => this.hear(line));
    this.device.on('message', ({id, data}) => {
      const line = `${id.toString(16).toUpperCase().padStart(3, '0')}#${data.toString('hex').toUpperCase()}`;
      this.note(line);
      this.peer.stdin.write(line + '\n');
    });
    this.device.start();
  }

  note(line) {
    fs.writeSync(this.log, `(${(Date.now() / 1000).toFixed(6)}) can0 ${line}\n`);
    this.frames.push(line);
  }

  hear(line) {
    this.note(line);
    const [, id, hex] = /^([0-9A-F]{3})#([0-9A-F]*)$/.exec(line);
    const data = Buffer.from(hex, 'hex');
    setImmediate(() => this.device.receive({id: parseInt(id, 16), data, len: data.length}));
    this.waiting = this.waiting.filter(({wanted, resolve}) => wanted !== line || resolve());
  }

  hears(wanted) {
    if (this.frames.includes(wanted)) return Promise.resolve();
    return new Promise((resolve, reject) => {
      setTimeout(() => reject(new Error(`nobody said ${wanted}`)), PATIENCE).unref();
      this.waiting.push({wanted, resolve});
    });
  }
}

// Fastscan finds the one of which the first bit that differs is zero.
async function findsAllByFastscan(network) {
  const {device, frames} = network;
  const found = [];
  for (let id = 10; ; ++id) {
    const identity = await device.lss.fastscan({timeout: TIMEOUT});
    if (identity === null) break;
    const {serialNumber, ...kind} = identity;
    assert.deepStrictEqual(kind, KIND);
    found.push(serialNumber);
    await device.lss.configureNodeId(id, PATIENCE);
    assert.ok(!frames.includes(`7${id.toString(16).toUpperCase().padStart(2, '0')}#00`), 'it boots too early');
    device.lss.switchModeGlobal(OPERATION);
    await network.hears(`7${id.toString(16).toUpperCase().padStart(2, '0')}#00`);
  }
  assert.deepStrictEqual(found, [77, 0x80000001, 0x80000003]);
}

async function findsNothingMore({device}) {
  assert.strictEqual(await device.lss.fastscan({timeout: TIMEOUT}), null);
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
  await assert.rejects(device.lss.switchModeSelective({...KIND, serialNumber: 78, timeout: TIMEOUT}));
  device.lss.switchModeGlobal(CONFIGURATION);
  device.lss.switchModeGlobal(OPERATION);
}

async function main() {
  const network = new Network();
  for (const test of [findsAllByFastscan, findsNothingMore, configuresOneThatItSelects, getsNoAnswerOfAnotherAddress]) {
    await test(network);
    console.log(`${test.name} passed`);
  }
  network.device.stop();
  network.peer.stdin.end();
}

main().then(() => process.exit(0), (error) => {
  console.error(error);
  process.exit(1);
});
