'use strict';

// node-canopen has a node of ours store its parameters, restore them, and take a program; each holds when the node is
// started again.
//
//     node tests/strangers/storage/storage_test.js PEER
//
// PEER is the program of peer.cpp; frames go through its standard input and output.

const assert = require('assert');
const {spawn} = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');
const readline = require('readline');
const zlib = require('zlib');

const {Device, Eds} = require('canopen');

const TIMEOUT_MS = 30000;
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'canvoy-'));

function number(value, bytes) {
  const data = Buffer.alloc(bytes);
  data.writeUIntLE(value, 0, bytes);
  return data;
}

// Our node from power-on to power-off, and node-canopen as its client.
class Life {
  static async begin() {
    const life = new Life();
    await new Promise((resolve) => life.lines.once('line', resolve)); // the boot-up message
    return life;
  }

  constructor() {
    const files = ['parameters', 'program'].map((name) => path.join(folder, name));
    this.peer = spawn(process.argv[2], files, {stdio: ['pipe', 'pipe', 'inherit']});
    this.lines = readline.createInterface({input: this.peer.stdout});
    const eds = new Eds();
    eds.addSdoClientParameter(5, 0x605, 0x585);
    this.device = new Device({id: 1, eds});
    this.lines.on('line', (line) => this.deliver(line));
    this.device.on('message', ({id, data}) => {
      const name = id.toString(16).toUpperCase().padStart(3, '0');
      this.peer.stdin.write(`${name}#${data.toString('hex').toUpperCase()}\n`);
    });
    this.device.start();
  }

  deliver(line) {
    const [, id, hex] = /^([0-9A-F]{3})#([0-9A-F]*)$/.exec(line) ?? [];
    if (!id) return;
    const data = Buffer.from(hex, 'hex');
    setImmediate(() => this.device.receive({id: parseInt(id, 16), data, len: data.length}));
  }

  write(index, subIndex, data, more = {}) {
    return this.device.sdo.download({deviceId: 5, index, subIndex, data, timeout: TIMEOUT_MS, ...more});
  }

  async read(index, subIndex = 0) {
    const data = await this.device.sdo.upload({deviceId: 5, index, subIndex, timeout: TIMEOUT_MS});
    return Buffer.from(data).readUIntLE(0, data.length);
  }

  async end() {
    this.device.stop();
    const ended = new Promise((resolve) => this.peer.once('exit', resolve));
    this.peer.stdin.end();
    assert.strictEqual(await ended, 0);
  }
}

async function within(work) {
  const life = await Life.begin();
  await work(life);
  await life.end();
}

async function storesParameters() {
  await within(async (life) => {
    assert.strictEqual(await life.read(0x6000), 42);
    await life.write(0x6000, 0, number(4711, 4));
    await life.write(0x1017, 0, number(700, 2));
    await life.write(0x1010, 1, Buffer.from('save'));
    await life.write(0x6000, 0, number(1, 4));
  });
  await within(async (life) => {
    assert.strictEqual(await life.read(0x6000), 4711);
    assert.strictEqual(await life.read(0x1017), 700);
  });
}

async function refusesAnotherSignature() {
  await within(async (life) => {
    await assert.rejects(life.write(0x1010, 1, Buffer.from('SAVE')), (error) => error.code === 0x08000020);
  });
}

async function restoresDefaults() {
  await within(async (life) => {
    await life.write(0x1011, 1, Buffer.from('load'));
    assert.strictEqual(await life.read(0x6000), 4711);
  });
  await within(async (life) => {
    assert.strictEqual(await life.read(0x6000), 42);
    assert.strictEqual(await life.read(0x1017), 0);
  });
}

async function takesAProgram() {
  const program = Buffer.from(Array.from({length: 10000}, (_, i) => (i * 31 + (i >> 8)) & 0xFF));
  for (const blockTransfer of [false, true]) {
    await within(async (life) => {
      await life.write(0x1F51, 1, number(0, 1));
      await life.write(0x1F51, 1, number(3, 1));
      assert.strictEqual(await life.read(0x1F57, 1), 0);
      await life.write(0x1F50, 1, program, {blockTransfer, blockInterval: 0});
      assert.strictEqual(await life.read(0x1F57, 1), 0);
      await life.write(0x1F51, 1, number(1, 1));
      assert.strictEqual(await life.read(0x1F51, 1), 1);
    });
    await within(async (life) => {
      assert.strictEqual(await life.read(0x1F56, 1), zlib.crc32(program));
    });
  }
}

async function main() {
  for (const test of [storesParameters, refusesAnotherSignature, restoresDefaults, takesAProgram]) {
    await test();
    console.log(`${test.name} passed`);
  }
}

main().then(() => 0, (error) => {
  console.error(error);
  return 1;
}).then((status) => {
  fs.rmSync(folder, {recursive: true});
  process.exit(status);
});
