'use strict';

// Slaves of node-canopen are booted by an NMT master of ours: one comes up, though node-canopen sends no boot-up message,
// one is of another vendor, one is not there, and one restarts while it runs.
//
//     node tests/strangers/boot/boot_test.js PEER
//
// PEER is the program of peer.cpp; frames go through its standard input and output, and its time is ours.

const assert = require('assert');
const {spawn} = require('child_process');
const readline = require('readline');

const {Device, Eds} = require('canopen');

const STEP_MS = 10; // of the master's time, for each of which a frame may go to and fro
const OPERATIONAL = 5;

function slave(id, vendor) {
  const eds = new Eds();
  eds.addSdoServerParameter(0, 0x580 + id, 0x600 + id);
  // An NMT reset gives its dictionary the default values.
  const deviceType = eds.getEntry(0x1000);
  deviceType.value = deviceType.defaultValue = 0xf0191;
  const identity = {vendorId: vendor, productCode: 7, revisionNumber: 1, serialNumber: 0xdeadbe00 + id};
  eds.setIdentity(identity, {saveDefault: true});
  return new Device({id, eds});
}

class Network {
  constructor(peer, devices) {
    this.devices = devices;
    this.frames = [];
    this.reports = [];
    this.now = 0;
    this.peer = spawn(peer, {stdio: ['pipe', 'pipe', 'inherit']});
    this.lines = readline.createInterface({input: this.peer.stdout});
    this.lines.on('line', (line) => this.hear(line));
    for (const device of devices) {
      device.on('message', ({id, data}) => {
        this.say(`${id.toString(16).toUpperCase().padStart(3, '0')}#${data.toString('hex').toUpperCase()}`);
      });
      device.start();
    }
  }

  hear(line) {
    if (line.startsWith('report ')) return this.reports.push(line);
    const [, id, hex] = /^([0-9A-F]{3})#([0-9A-F]*)$/.exec(line) ?? [];
    if (!id) return;
    this.frames.push(line);
    const data = Buffer.from(hex, 'hex');
    for (const device of this.devices) {
      setImmediate(() => device.receive({id: parseInt(id, 16), data, len: data.length}));
    }
  }

  say(line) {
    this.peer.stdin.write(line + '\n');
  }

  async runUntil(ms) {
    while (this.now < ms) {
      this.now += STEP_MS;
      const reached = new Promise((resolve) => {
        const look = (line) => {
          if (line !== `now ${this.now}`) return;
          this.lines.off('line', look);
          resolve();
        };
        this.lines.on('line', look);
      });
      this.say(`until ${this.now}`);
      await reached;
      await new Promise((resolve) => setTimeout(resolve, 1));
    }
  }
}

async function main() {
  const good = slave(10, 0x123);
  const foreign = slave(11, 0x124);
  const network = new Network(process.argv[2], [good, foreign]);
  await network.runUntil(4000);

  // It was reset and asked again, since it sends no boot-up message.
  assert.ok(network.reports.includes('report 10 1 7 - 0 0'), network.reports.join('\n'));
  assert.ok(network.reports.includes('report 10 5 11 - 0 0'), network.reports.join('\n'));
  assert.strictEqual(network.frames.filter((frame) => frame === '000#010A').length, 1);
  assert.strictEqual(good.nmt.state, OPERATIONAL);
  console.log('a slave without a boot-up message comes up');

  assert.ok(network.reports.includes('report 11 4 2 D 123 124'), network.reports.join('\n'));
  assert.ok(!network.frames.includes('000#010B'));
  assert.notStrictEqual(foreign.nmt.state, OPERATIONAL);
  console.log('a slave of another vendor is refused');

  assert.ok(network.reports.includes('report 12 3 1 B F0191 0'), network.reports.join('\n'));
  assert.ok(!network.frames.includes('000#010C'));
  console.log('a slave that is not there is asked for again');

  network.frames.length = 0;
  network.say('70A#00');
  await network.runUntil(5000);
  assert.ok(network.reports.includes('report 10 2 11 - 0 0'), network.reports.join('\n'));
  assert.strictEqual(network.frames.filter((frame) => frame === '000#010A').length, 1);
  console.log('a slave that restarts is booted again');
  network.peer.stdin.end();
}

main().then(() => process.exit(0), (error) => {
  console.error(error);
  process.exit(1);
});
