'use strict';

// node-canopen and our SDO client and server, each with the other: expedited, in segments and in blocks.
//
//     node sdo_test.js PEER

const assert = require('node:assert');
const {test} = require('node:test');
const {Device, Eds, DataType} = require('canopen');
const {Wire} = require('../wire');

const PEER = process.argv[2];
const TIME_OUT_MS = 20000; // the machine may be busy
const SIZES = [1, 2, 3, 4, 5, 7, 8, 14, 889, 890, 896, 1778, 10000, 100000];

// Our program, and a device of node-canopen whose bus it is.
function connect(eds, id, mode) {
  const wire = new Wire(PEER, mode);
  const device = new Device({id, eds});
  wire.connect(device);
  device.start();
  return {wire, device};
}

function pattern(size) {
  return Buffer.from(Array.from({length: size}, (_, i) => (i * 31 + Math.floor(i / 7) + size) & 0xff));
}

test('node-canopen writes and reads our server', async (t) => {
  const eds = new Eds();
  eds.addSdoClientParameter(5, 0x605, 0x585);
  const {wire, device} = connect(eds, 1, 'serve');
  device.nmt.startNode();
  const at = (index) => ({deviceId: 5, index, subIndex: 0, timeout: TIME_OUT_MS});

  // What is empty can be read; it writes it as 4 bytes, and in blocks as 7.
  for (const blockTransfer of [false, true]) {
    await t.test(`nothing, ${blockTransfer ? 'in blocks' : 'in segments'}`, async () => {
      const read = await device.sdo.upload({...at(0x2030), blockTransfer});
      assert.equal(read?.length ?? 0, 0);
    });
  }
  for (const [index, type, value] of [[0x2001, 'UNSIGNED8', 0x42], [0x2002, 'UNSIGNED16', 0x1234],
    [0x2004, 'UNSIGNED32', 0x12345678]]) {
    await t.test(`expedited, ${type}`, async () => {
      await device.sdo.download({...at(index), data: value, dataType: DataType[type]});
      assert.equal(await device.sdo.upload({...at(index), dataType: DataType[type]}), value);
    });
  }
  for (const blockTransfer of [false, true]) {
    for (const size of SIZES) {
      await t.test(`${size} bytes, ${blockTransfer ? 'in blocks' : 'in segments'}`, async () => {
        const data = pattern(size);
        await device.sdo.download({...at(0x2030), data, blockTransfer, blockInterval: 0});
        const read = await device.sdo.upload({...at(0x2030), blockTransfer, blockInterval: 0});
        assert.deepEqual(Buffer.from(read), data);
      });
    }
  }
  await t.test('what is not there is aborted', async () => {
    await assert.rejects(device.sdo.upload({...at(0x2999)}));
  });
  assert.equal(await wire.end(), 0);
});

test('our client writes and reads a server of node-canopen', async () => {
  const eds = new Eds();
  eds.addSdoServerParameter(0, 0x58a, 0x60a);
  eds.addEntry(0x2030, {parameterName: 'data', dataType: DataType.DOMAIN, accessType: 'rw'});
  const {wire, device} = connect(eds, 10, 'ask');
  device.sdoServer?.setBlockInterval?.(0);
  device.nmt.startNode();
  const status = await new Promise((resolve) => wire.peer.on('exit', resolve));
  assert.equal(status, 0);
});
