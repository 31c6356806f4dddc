'use strict';

// A battery and a charger, each a process, on a real CAN interface; node-canopen is their NMT master and SDO client,
// candump and `canvoy monitor` listen, and canplayer throws garbage.
//
//     node tests/strangers/charging/charging_test.js COMMAND FOLDER
//
// COMMAND is canvoy; candump.log and canvoy.log are left in FOLDER, and in garbage.txt what was thrown.

const assert = require('assert');
const {execFileSync} = require('child_process');
const fs = require('fs');
const path = require('path');
const {AccessType, DataType, Eds, ObjectType, SdoCode} = require('canopen');
const {CanBus, SPEAKERS, LISTENERS} = require('./can_bus');
const {assertSameLog} = require('./logs');
const {Master, BATTERY, CHARGER} = require('./master');
const {Program} = require('./program');

const [command, folder] = process.argv.slice(2);
const BUS = 'vcan0';
const BEGIN = '7FF#C0FFEE00';
const END = '7FF#C0FFEE01';
const PRE_OPERATIONAL = 127;
const OPERATIONAL = 5;
const STOPPED = 4;
const CHARGER_READY = '20A#01'; // the charger's TPDO 1 on the battery's RPDO 1: its status (CiA 419, 6.2.4)

const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

async function listen() {
  const log = path.join(folder, 'canvoy.log');
  const monitor = new Program(LISTENERS, command, 'monitor', BUS, '--log', log);
  while (!fs.existsSync(log)) await sleep(50);
  const bus = new CanBus(BUS, path.join(folder, 'candump.log'));
  // candump hears nothing until its socket is open.
  for (let tries = 0; tries < 100 && bus.heard.length === 0; ++tries) {
    bus.throwIn('7FF#');
    await sleep(200);
  }
  await bus.mark(BEGIN);
  return {bus, monitor};
}

async function startDevices(bus) {
  const isBootUp = (node) => (frame) => frame.id === 0x700 + node && frame.text.endsWith('#00');
  const batteryBoots = bus.until('the boot-up of the battery', isBootUp(BATTERY));
  const battery = new Program(SPEAKERS, command, 'device', 'battery', BUS, '--node-id', `${BATTERY}`);
  await batteryBoots;
  const chargerBoots = bus.until('the boot-up of the charger', isBootUp(CHARGER));
  const charger = new Program(SPEAKERS, command, 'device', 'charger', BUS, '--node-id', `${CHARGER}`,
    '--no-manage');
  await chargerBoots;
  // The charger asks by the battery's SDO server, which has one client at a time.
  await charger.says(/linked to node 10/);
  await bus.mark('7FF#00');
  return {battery, charger};
}

async function readsTheDictionaries(master) {
  assert.strictEqual(await master.read(BATTERY, 0x1000, 0, DataType.UNSIGNED32) & 0xffff, 418);
  assert.strictEqual(await master.read(CHARGER, 0x1000, 0, DataType.UNSIGNED32) & 0xffff, 419);
  assert.strictEqual(await master.read(BATTERY, 0x1018, 0, DataType.UNSIGNED8), 4);
  assert.strictEqual(await master.read(BATTERY, 0x1018, 2, DataType.UNSIGNED32), 418);
  assert.strictEqual(await master.read(CHARGER, 0x1018, 2, DataType.UNSIGNED32), 419);
  const name = await master.read(BATTERY, 0x1008, 0, DataType.VISIBLE_STRING);
  assert.strictEqual(name, 'Canvoy CiA 418 battery'); // more than four bytes: in segments
  const celsius = await master.read(BATTERY, 0x6010, 0, DataType.INTEGER16) / 8;
  assert.ok(celsius > 10 && celsius < 40, `${celsius} degrees`);
  const volt = await master.read(BATTERY, 0x6060, 0, DataType.UNSIGNED32) / 1024;
  assert.ok(volt > 40 && volt < 65, `${volt} V`);
}

// Every entry that the data sheet of the battery says can be read.
async function readsByTheDataSheet(master) {
  const sheet = path.join(folder, 'battery.eds');
  execFileSync(command, ['eds', 'export', 'battery', '--out', sheet]);
  const eds = Eds.fromFile(sheet);
  let count = 0;
  for (const object of eds.values()) {
    if (object.index === 0x1003) continue; // empty: its entries are not there (CiA 301, 7.5.2.4)
    const isOne = ![ObjectType.ARRAY, ObjectType.RECORD].includes(object.objectType);
    const entries = isOne ? [object] : [...Array(256).keys()].map((sub) => object.at(sub)).filter(Boolean);
    for (const each of entries) {
      if (each.accessType === AccessType.WRITE_ONLY) continue;
      const value = await master.read(BATTERY, object.index, each.subIndex ?? 0, each.dataType);
      if (each.accessType === AccessType.CONSTANT) assert.strictEqual(value, each.value, `${each}`);
      ++count;
    }
  }
  assert.ok(count > 50, `${count} entries`);
}

async function readsAborts(master) {
  const ask = (index, sub) => master.abortOf(master.read(BATTERY, index, sub));
  assert.strictEqual(await ask(0x2345, 0), SdoCode.OBJECT_UNDEFINED);
  assert.strictEqual(await ask(0x1018, 9), SdoCode.BAD_SUB_INDEX);
  const write = (index, data, type) => master.abortOf(master.write(BATTERY, index, 0, data, type));
  assert.strictEqual(await write(0x6010, 0, DataType.INTEGER16), SdoCode.READ_ONLY);
  assert.strictEqual(await write(0x1017, 1, DataType.UNSIGNED32), SdoCode.DATA_LONG);
}

// 1017h from the default of 1000 ms to 250 ms, as the kernel's time stamps show. An emulated machine may stand still for
// a moment: then one distance is long, and the next short.
async function hearsHeartbeats(bus, master) {
  const distances = async () => {
    const times = [];
    while (times.length < 6) times.push((await bus.until('a heartbeat', (frame) => frame.id === 0x700 + BATTERY)).time);
    return times.slice(1).map((time, i) => time - times[i]);
  };
  assert.ok(Math.max(...await distances()) > 0.9, '1000 ms');
  await master.write(BATTERY, 0x1017, 0, 250, DataType.UNSIGNED16);
  assert.strictEqual(await master.read(BATTERY, 0x1017, 0, DataType.UNSIGNED16), 250);
  assert.ok(Math.min(...await distances()) < 0.7, '250 ms');
  await master.hears('that both are pre-operational', () => master.bothAre(PRE_OPERATIONAL));
}

// The charger has set its heartbeat consumer to two periods of the battery, which is short for an emulated machine.
async function givesTheHeartbeatTime(master) {
  const consumer = await master.read(CHARGER, 0x1016, 1, DataType.UNSIGNED32);
  assert.strictEqual(consumer, BATTERY << 16 | 2000);
  await master.write(CHARGER, 0x1016, 1, BATTERY << 16 | 60000, DataType.UNSIGNED32);
}

async function chargeBegins(bus, master) {
  const ready = bus.until('that the charger is ready', (frame) => frame.text === CHARGER_READY);
  const pdo = bus.until('the TPDO 3 of the battery', (frame) => frame.id === 0x380 + BATTERY);
  master.device.nmt.startNode(BATTERY);
  master.device.nmt.startNode(CHARGER);
  await ready;
  await pdo;
  await master.hears('that both are operational', () => master.bothAre(OPERATIONAL));
}

function batteryPdosMakeSense({readings}) {
  const celsius = readings.temperature.value / 8;
  const volt = readings.voltage.value / 1024;
  const ampere = readings.current.value / 16;
  assert.ok(celsius > 10 && celsius < 40, `${celsius} degrees`);
  assert.ok(volt > 40 && volt < 65, `${volt} V`);
  assert.ok(ampere > 0 && ampere <= 60, `${ampere} A are requested`);
  assert.strictEqual(readings.status.value & 1, 1);
  assert.ok(readings.charge.value >= 20 && readings.charge.value < 30, `charged to ${readings.charge.value} %`);
}

// What the charger has returned so far, in 1/8 Ah: its TPDO 2 on the battery's RPDO 2.
async function chargeGoesOn(bus) {
  const returned = (frame) => (frame.id === 0x300 + BATTERY && frame.data.length === 3 ? frame.data.readUInt16LE(1) : -1);
  const now = returned(await bus.until('the TPDO 2 of the charger', (frame) => returned(frame) >= 0));
  await bus.until(`more than ${now / 8} Ah`, (frame) => returned(frame) > now && frame.data[0] === 1);
}

// Nobody answers to these, and nothing comes of them.
const IGNORED = [
  // SDO requests of a wrong length, remote, or with 29 bits
  '60A#', '60A#40', '60A#401010', '605#40001000000000', '60A#R8', '605#R0', '0000060A#4000100000000000',
  // NMT commands that are none, are for others, or are cut off
  '000#', '000#02', '000#020A00', '000#030A', '000#0242', '00000000#020A', '000#R2',
  // a heartbeat and an emergency of strangers
  '70B#05', '08B#1082010000000000',
  // COB-IDs of nobody, SYNC without a PDO that waits for it, and TIME that nobody wants
  '001#01', '123#', '333#0102030405060708', '6FF#FF', '7FE#00', '1FFFFFFF#0102030405060708', '080#',
  '100#', '100#010203040506',
  // RPDOs as remote frames, and with 29 bits
  '20A#R1', '30A#R3', '0000020A#00', '0000028A#FFFF',
  // the PDOs of a charger that is not there, LSS, and a remote request for what nobody allows
  '207#0102', '7E5#0401000000000000', '705#R1',
];

async function ignoresWhatIsNotForIt(bus, throwIn) {
  const from = bus.heard.length;
  for (const text of IGNORED) throwIn(text);
  await bus.mark('7FF#01');
  await sleep(500);
  // RPDO time-out and its end: the machine may have stood still.
  const isLate = ({id, data}) => id === 0x80 + CHARGER && data.length === 8 && [0x8250, 0].includes(data.readUInt16LE(0));
  const answers = bus.heard.slice(from).filter((frame) => !IGNORED.includes(frame.text) && !isLate(frame))
    .filter(({id}) => [BATTERY, CHARGER].some((node) => [0x580 + node, 0x80 + node].includes(id)));
  assert.deepStrictEqual(answers.map((frame) => frame.text), []);
}

// CiA 301, table of emergency error codes, 8150h: another node sends what only the battery sends, heartbeats and
// emergencies. It tells so once, with the first CAN-ID in the manufacturer-specific field, and once that it has ended.
async function tellsOfAStrangerOnItsCanIds(bus, throwIn) {
  const from = bus.heard.length;
  const emergency = (code) => ({id, data}) => id === 0x80 + BATTERY && data.length === 8 && data.readUInt16LE(0) === code;
  const told = bus.until('emergency 8150 of the battery', emergency(0x8150));
  for (const text of ['70A#', '70A#7F7F', '70A#01', '08A#', '08A#1082']) throwIn(text);
  assert.strictEqual((await told).data.readUInt16LE(3), 0x70A);
  await bus.until('its end', emergency(0));
  assert.strictEqual(bus.heard.slice(from).filter(emergency(0x8150)).length, 1);
}

// CiA 301, 7.2.5.2: the battery, which has a SYNC consumer, tells of data that 1019h does not announce, until a right one.
async function tellsOfASyncWithData(bus, throwIn) {
  const from = bus.heard.length;
  const tells = (code) => bus.until(`emergency ${code.toString(16)} of the battery`,
    ({id, data}) => id === 0x80 + BATTERY && data.length === 8 && data.readUInt16LE(0) === code);
  const told = tells(0x8240);
  throwIn('080#0102030405060708');
  await told;
  const ended = tells(0);
  throwIn('080#');
  await ended;
  assert.ok(!bus.heard.slice(from).some(({id, data}) => id === 0x80 + CHARGER && data.readUInt16LE(0) === 0x8240));
}

// CiA 301, 7.2.4.3: what is no command gets the abort 0504 0001h.
async function refusesUnknownCommands(bus, throwIn) {
  for (const text of ['60A#E000100000000000', '60A#6000000000000000', '605#FFFFFFFFFFFFFFFF', '605#00AABBCCDDEEFF00']) {
    const server = Number.parseInt(text.slice(0, 3), 16) - 0x80;
    const abort = bus.until(`the abort of ${text}`, ({id}) => id === server);
    throwIn(text);
    const {data} = await abort;
    assert.deepStrictEqual([data[0], data.readUInt32LE(4)], [0x80, SdoCode.BAD_COMMAND], text);
  }
}

// CiA 301, 7.3.1 and the table of emergency error codes: 8210h too short, 8220h too long.
async function tellsOfPdosOfWrongLength(bus, master, throwIn) {
  const provoke = async (text, node, code) => {
    const told = bus.until(`emergency ${code.toString(16)} of node ${node} after ${text}`,
      ({id, data}) => id === 0x80 + node && data.length === 8 && data.readUInt16LE(0) === code);
    throwIn(text);
    await told;
  };
  await provoke('20A#', BATTERY, 0x8210);
  await provoke('20A#0100', BATTERY, 0x8220);
  await provoke('28A#', CHARGER, 0x8210);
  const {data} = await bus.until('a TPDO 2 of the battery', (frame) => frame.id === 0x28A && frame.data.length === 7);
  await provoke(`28A#${data.toString('hex').toUpperCase()}00`, CHARGER, 0x8220);
  for (const node of [BATTERY, CHARGER]) {
    for (const code of [0x8210, 0x8220]) {
      await master.hears(`emergency ${code.toString(16)} of node ${node}`,
        () => master.emergencies.some((told) => told.node === node && told.code === code));
    }
  }
}

// A client begins to read a string, and is never heard of again: abort 0504 0000h, once.
async function givesUpVanishedClients(bus, throwIn) {
  const isAbort = ({id, data}) => id === 0x580 + BATTERY && data[0] === 0x80;
  const begun = bus.until('the begin of an upload', ({id, data}) => id === 0x580 + BATTERY && data[0] === 0x41);
  throwIn('60A#4008100000000000');
  const {time} = await begun;
  const abort = await bus.until('the abort after the time-out', isAbort);
  assert.strictEqual(abort.text, '58A#8008100000000405');
  assert.ok(abort.time - time > 0.5, 'the SDO time-out of 1 s');
}

async function stillWorks(bus, master) {
  assert.strictEqual(await master.read(CHARGER, 0x1000, 0, DataType.UNSIGNED32) & 0xffff, 419);
  assert.strictEqual(await master.read(BATTERY, 0x1008, 0, DataType.VISIBLE_STRING), 'Canvoy CiA 418 battery');
  await master.hears('that both are operational', () => master.bothAre(OPERATIONAL));
  batteryPdosMakeSense(master);
  await chargeGoesOn(bus);
}

async function stops(bus, master) {
  const stopped = Promise.all([BATTERY, CHARGER].map(
    (node) => bus.until(`node ${node} stopped`, (frame) => frame.id === 0x700 + node && frame.data[0] === STOPPED)));
  master.device.nmt.stopNode(0);
  await stopped;
}

async function main() {
  const step = async (name, action) => {
    await action;
    console.log(`${(process.uptime()).toFixed(0).padStart(4)} s  ${name}`);
  };
  const {bus, monitor} = await listen();
  await step('all listen');
  const {battery, charger} = await startDevices(bus);
  await step('the charger has found the battery');

  const master = new Master(bus);
  await step('node-canopen reads both dictionaries', readsTheDictionaries(master));
  await step('it reads all that the data sheet of the battery names', readsByTheDataSheet(master));
  await step('it gets the aborts of CiA 301', readsAborts(master));
  await step('it hears heartbeats, and sets their period', hearsHeartbeats(bus, master));
  await step('it configures the heartbeat consumer', givesTheHeartbeatTime(master));
  await step('it starts both nodes, and the charge begins', chargeBegins(bus, master));
  await step('the battery sends what is physically possible', batteryPdosMakeSense(master));
  await step('the charge goes on', chargeGoesOn(bus));

  const garbage = [];
  const throwIn = (text) => {
    garbage.push(text);
    bus.throwIn(text);
  };
  await step('garbage: what is not for them is ignored', ignoresWhatIsNotForIt(bus, throwIn));
  await step('garbage: a stranger on its CAN-IDs is told of', tellsOfAStrangerOnItsCanIds(bus, throwIn));
  await step('garbage: a SYNC with data is told of', tellsOfASyncWithData(bus, throwIn));
  await step('garbage: unknown SDO commands are refused', refusesUnknownCommands(bus, throwIn));
  await step('garbage: PDOs of wrong length are told of', tellsOfPdosOfWrongLength(bus, master, throwIn));
  await step('garbage: vanished SDO clients are given up', givesUpVanishedClients(bus, throwIn));
  await step('both still work', stillWorks(bus, master));
  await step('node-canopen stops both', stops(bus, master));

  // Of the stranger that has sent one heartbeat.
  await step('the monitor tells that node 11 is silent', monitor.says(/node 11 /, {on: 'errors'}));
  await bus.mark(END);
  for (const program of [charger, battery]) await program.end();
  // On a slow machine those that have ended are silent for long enough, too.
  await monitor.end(/^vcan0: node 11 \(0Bh\): no heartbeat any more\n(vcan0: node (5|10) \(\w+\): no heartbeat any more\n)*$/);
  assert.match(charger.out, /the charge begins/);
  assert.match(battery.out, /operational/);
  await step('all programs have ended without complaint');
  master.close();
  bus.close();
  fs.writeFileSync(path.join(folder, 'garbage.txt'), garbage.join('\n') + '\n');
  const frames = assertSameLog(path.join(folder, 'candump.log'), path.join(folder, 'canvoy.log'), BEGIN, END);
  console.log(`the logs of candump and canvoy have the same ${frames} frames in the same order`);
}

main().then(() => process.exit(0), (error) => {
  console.error(error);
  process.exit(1);
});
