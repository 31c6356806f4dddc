'use strict';

// node-canopen has a node of ours store its parameters, restore them, and take a program; each holds when the node is
// started again.
//
//     node tests/strangers/storage/storage_test.js PEER
//
// PEER is the program of peer.cpp.

const assert = require('assert');
const fs = require('fs');
const os = require('os');
const path = require('path');
const {Eds} = require('canopen');
const {Stranger} = require('../stranger');
const {Wire} = require('../wire');

const NODE = 5;

// CRC-32 of IEEE 802.3; zlib of Debian's Node.js has none.
const crc32 = (bytes) => {
  let crc = 0xFFFFFFFF;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; ++bit) crc = (crc >>> 1) ^ (crc & 1 ? 0xEDB88320 : 0);
  }
  return (crc ^ 0xFFFFFFFF) >>> 0;
};
assert.strictEqual(crc32(Buffer.from('123456789')), 0xCBF43926);  // the check value that catalogues of CRCs name

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'canvoy-'));

function number(value, bytes) {
  const data = Buffer.alloc(bytes);
  data.writeUIntLE(value, 0, bytes);
  return data;
}

// Our node from power-on to power-off, and node-canopen as its client.
class Life extends Stranger {
  constructor() {
    const files = ['parameters', 'program'].map((name) => path.join(folder, name));
    super(new Wire(process.argv[2], ...files), 1, NODE, new Eds());
  }

  write(index, subIndex, data, more) {
    return super.write(index, subIndex, data, undefined, more);
  }

  async read(index, subIndex = 0) {
    const data = await super.read(index, subIndex);
    return Buffer.from(data).readUIntLE(0, data.length);
  }

  async end() {
    this.device.stop();
    assert.strictEqual(await this.wire.end(), 0);
  }
}

async function within(work) {
  const life = new Life();
  await life.open();
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
      assert.strictEqual(await life.read(0x1F56, 1), crc32(program));
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
