'use strict';

// PDOs and SYNC with node-canopen, both ways: it configures a node of ours by SDO as CiA 301 prescribes, sends and
// receives PDOs, consumes our SYNC with counter and produces its own.
//
//     node tests/strangers/pdo/pdo_test.js PEER
//
// PEER is the program of peer.cpp.

const assert = require('assert');
const {Eds, DataType} = require('canopen');
const {Stranger} = require('../stranger');
const {Wire, run} = require('../wire');

const NODE = 5;
const INVALID = 0x80000000;

class Master extends Stranger {
  constructor(wire) {
    const eds = new Eds();
    super(wire, 1, NODE, eds);
    eds.setSyncCobId(0x80);
    const entry = (index, dataType) => eds.addEntry(index, {parameterName: `object ${index}`, dataType});
    this.sent = [entry(0x2000, DataType.UNSIGNED16), entry(0x2001, DataType.INTEGER8), entry(0x2002, DataType.UNSIGNED32)];
    this.received = [entry(0x3000, DataType.UNSIGNED16), entry(0x3001, DataType.INTEGER8),
      entry(0x3002, DataType.UNSIGNED32)];
    eds.addTransmitPdo({cobId: 0x200 + NODE, transmissionType: 254, dataObjects: this.sent});
    eds.addReceivePdo({cobId: 0x180 + NODE, dataObjects: this.received});
    this.eds = eds;
  }

  // By the procedure of CiA 301: invalid, no mapping, entries, their number, valid.
  async map(parameters, cobId, type, entries) {
    await this.write(parameters, 1, cobId + INVALID, DataType.UNSIGNED32);
    await this.write(parameters, 2, type, DataType.UNSIGNED8);
    await this.write(parameters + 0x200, 0, 0, DataType.UNSIGNED8);
    for (const [i, entry] of entries.entries()) await this.write(parameters + 0x200, i + 1, entry, DataType.UNSIGNED32);
    await this.write(parameters + 0x200, 0, entries.length, DataType.UNSIGNED8);
    await this.write(parameters, 1, cobId, DataType.UNSIGNED32);
  }
}

const ALL = [0x20000010, 0x20010008, 0x20020020];

// What node-canopen sends comes back from our TPDO, which maps the same objects.
async function echoes(wire, master) {
  await master.map(0x1400, 0x200 + NODE, 254, ALL);
  await master.map(0x1800, 0x180 + NODE, 254, ALL);
  master.start();
  await wire.until('the first TPDO', () => wire.heard.includes('185#00000000000000'));
  let pdos = 0;
  master.device.pdo.on('pdo', () => ++pdos);
  for (let i = 1; i <= 50; ++i) {
    const values = [i * 1301, i % 2 === 0 ? i : -i, i * 80000001];
    for (const [place, value] of values.entries()) master.sent[place].value = value;
    await wire.until(`the echo of ${values}`, () => master.received.every(({value}, place) => value === values[place]));
  }
  assert.ok(pdos >= 50, `${pdos} PDO events`);
}

// Our TPDO 2 of type 2 with SYNC start value 3: the SYNC with 3 is the first, so it is sent at 4, 6, 8, 10, 2 ...
async function followsItsSync(wire, master) {
  await master.write(0x1019, 0, 10, DataType.UNSIGNED8);
  await master.write(0x1801, 1, 0x285 + INVALID, DataType.UNSIGNED32);
  await master.write(0x1801, 6, 3, DataType.UNSIGNED8);
  await master.map(0x1801, 0x280 + NODE, 2, [0x20000010]);
  master.eds.setSyncOverflow(10);
  master.eds.setSyncCyclePeriod(50000);
  const from = wire.heard.length;
  master.eds.setSyncGenerationEnable(true);
  const answers = () => wire.heard.slice(from).filter((line) => line.startsWith('285#')).length;
  await wire.until('ten TPDOs', () => answers() >= 10);
  master.eds.setSyncGenerationEnable(false);
  const beats = wire.heard.slice(from).filter((line) => /^(>080|285)#/.test(line));
  const counters = [];
  for (const [i, line] of beats.entries()) {
    if (line.startsWith('285#')) counters.push(parseInt(beats[i - 1].slice(5), 16));
  }
  assert.deepStrictEqual(counters.slice(0, 10), [4, 6, 8, 10, 2, 4, 6, 8, 10, 2]);
  await master.write(0x1801, 1, 0x285 + INVALID, DataType.UNSIGNED32);
}

// Our SYNC with counter; node-canopen tells of each, and its TPDO of type 1 comes at each and reaches our RPDO 2.
async function leadsBySync(wire, master) {
  const counters = [];
  master.device.sync.on('sync', (counter) => counters.push(counter));
  const value = master.eds.addEntry(0x2100, {parameterName: 'with SYNC', dataType: DataType.UNSIGNED32});
  master.eds.addTransmitPdo({cobId: 0x300 + NODE, transmissionType: 1, dataObjects: [value]});
  await master.map(0x1401, 0x300 + NODE, 1, [0x20020020]);
  await master.write(0x1019, 0, 4, DataType.UNSIGNED8);
  await master.write(0x1006, 0, 20000, DataType.UNSIGNED32);
  value.value = 0x12345678;
  await master.write(0x1005, 0, 0x40000080, DataType.UNSIGNED32);
  await wire.until('ten SYNC', () => counters.length >= 10);
  assert.deepStrictEqual(counters.slice(0, 10), [1, 2, 3, 4, 1, 2, 3, 4, 1, 2]);
  await wire.until('the value of its synchronous TPDO', () => master.received[2].value === 0x12345678);
  await master.write(0x1005, 0, 0x80, DataType.UNSIGNED32);
}

async function refusesWhatCia301Forbids(master) {
  assert.strictEqual(await master.refusal(0x1800, 2, 245, DataType.UNSIGNED8), 0x06090030);
  assert.strictEqual(await master.refusal(0x1800, 1, 0x182, DataType.UNSIGNED32), 0x06090030);
  await master.write(0x1800, 1, 0x185 + INVALID, DataType.UNSIGNED32);
  await master.write(0x1A00, 0, 0, DataType.UNSIGNED8);
  assert.strictEqual(await master.refusal(0x1A00, 1, 0x2FFF0008, DataType.UNSIGNED32), 0x06020000);
  assert.strictEqual(await master.refusal(0x1A00, 1, 0x10000020, DataType.UNSIGNED32), 0x06040041);
  for (const sub of [1, 2, 3]) await master.write(0x1A00, sub, 0x20020020, DataType.UNSIGNED32);
  assert.strictEqual(await master.refusal(0x1A00, 0, 3, DataType.UNSIGNED8), 0x06040042);
}

async function main() {
  const wire = new Wire(process.argv[2]);
  const master = new Master(wire);
  await master.open();
  const steps = {echoes, followsItsSync, leadsBySync, refusesWhatCia301Forbids: () => refusesWhatCia301Forbids(master)};
  for (const [name, step] of Object.entries(steps)) {
    await step(wire, master);
    console.log(name);
  }
  const emergencies = wire.heard.filter((line) => line.startsWith('085#'));
  assert.deepStrictEqual(emergencies, []);
  await wire.end();
}

run(main);
