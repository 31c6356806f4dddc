'use strict';

// A seat with a stick in real hands on a real CAN interface: the stick is an input device of the kernel, which the test
// moves, unplugs and plugs in again; node-canopen is the host, which maps, enables and receives the joystick's PDO and
// switches indicators; candump listens.
//
//     node tests/strangers/operator/operator_test.js COMMAND FOLDER
//
// COMMAND is canvoy; candump.log is left in FOLDER.

const assert = require('assert');
const {spawn} = require('child_process');
const fs = require('fs');
const path = require('path');
const readline = require('readline');
const {DataType, Device, Eds} = require('canopen');
const {CanBus, SPEAKERS} = require('../charging/can_bus');
const {Program} = require('../charging/program');

const [command, folder] = process.argv.slice(2);
const BUS = 'vcan0';
const SEAT = 10;
const TIME_OUT_MS = 30000; // the machine is emulated
const PDO = 0x180 + SEAT;
const INVALID = 0x80000000;
const ABS_X = 0;
const ABS_Y = 1;
const BTN_TRIGGER = 0x120;
const LED_MUTE = 7;

const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

async function within(what, isSo, seconds = 60) {
  const giveUp = Date.now() + seconds * 1000;
  while (!isSo()) {
    assert.ok(Date.now() < giveUp, `within ${seconds} s: not ${what}`);
    await sleep(20);
  }
}

class Stick {
  constructor() {
    this.lines = [];
    this.child = spawn('python3', [path.join(__dirname, 'stick.py')], {stdio: ['pipe', 'pipe', 'inherit']});
    readline.createInterface({input: this.child.stdout}).on('line', (line) => this.lines.push(line));
  }
  // All of it in one write: the kernel has it at once.
  does(...lines) {
    this.child.stdin.write(lines.join('\n') + '\n');
  }
  async says(line, times = 1) {
    const count = () => this.lines.filter((each) => each.startsWith(line)).length;
    await within(`${line} from the stick`, () => count() >= times);
    return this.lines.filter((each) => each.startsWith(line)).at(-1).slice(line.length).trim();
  }
}

class Host {
  constructor(bus) {
    const eds = new Eds();
    eds.addSdoClientParameter(SEAT, 0x600 + SEAT, 0x580 + SEAT);
    eds.addEmcyConsumer(0x80 + SEAT);
    const entry = (index, dataType) => eds.addEntry(index, {parameterName: `raw ${index}`, dataType});
    this.x = entry(0x3000, DataType.INTEGER16);
    this.y = entry(0x3001, DataType.INTEGER16);
    this.buttons = entry(0x3002, DataType.UNSIGNED8);
    eds.addReceivePdo({cobId: PDO, dataObjects: [this.x, this.y, this.buttons]});
    this.emergencies = [];
    this.device = new Device({id: 1, eds});
    this.device.on('message', ({id, data}) => bus.send(id, data));
    bus.on('frame', (frame) => {
      if (frame.id === null || frame.remote) return;
      setImmediate(() => this.device.receive({id: frame.id, data: frame.data, len: frame.data.length}));
    });
    this.device.emcy.on('emergency', ({em}) => this.emergencies.push(em.code));
    this.device.start();
    this.device.nmt.startNode();
  }
  write(index, subIndex, data, dataType) {
    return this.device.sdo.download({deviceId: SEAT, index, subIndex, data, dataType, timeout: TIME_OUT_MS});
  }
  // TPDO 1 carries x, y and the buttons of joystick 1 (Table 1), and analogue inputs cause events.
  async configure() {
    await this.write(0x1A00, 0, 0, DataType.UNSIGNED8);
    const entries = [0x64010110, 0x64010210, 0x60000208];
    for (const [i, each] of entries.entries()) await this.write(0x1A00, i + 1, each, DataType.UNSIGNED32);
    await this.write(0x1A00, 0, entries.length, DataType.UNSIGNED8);
    await this.write(0x1800, 1, PDO, DataType.UNSIGNED32);
    await this.write(0x6423, 0, 1, DataType.UNSIGNED8);
    this.device.nmt.startNode(SEAT);
  }
  sees(what, x, y, buttons) {
    return within(what, () => this.x.value === x && this.y.value === y && this.buttons.value === buttons);
  }
}

async function listen() {
  const bus = new CanBus(BUS, path.join(folder, 'candump.log'));
  for (let tries = 0; tries < 100 && bus.heard.length === 0; ++tries) {
    bus.throwIn('7FF#');
    await sleep(200);
  }
  return bus;
}

function mappingFile(device) {
  const file = path.join(folder, 'stick.toml');
  // ABS_Y has an end of its own, a dead band, and is turned round; ABS_X is as the device says: 0 to 1023.
  fs.writeFileSync(file, `device = "${device}"
[[axis]]
code = "ABS_X"
moves = "joystick1.x"
centre = 512
[[axis]]
code = "ABS_Y"
moves = "joystick1.y"
least = 12
centre = 512
most = 1012
dead-band = 100
inverted = true
[[button]]
code = "BTN_TRIGGER"
presses = "joystick1.b3"
[[light]]
code = "LED_MUTE"
shows = "indicator-cluster1.i2"
`);
  return file;
}

async function main() {
  const bus = await listen();
  const stick = new Stick();
  const device = await stick.says('device');
  const boots = bus.until('the boot-up', (frame) => frame.text === '70A#00');
  const seat = new Program(SPEAKERS, command, 'device', 'operator', BUS, '--elements', 'joysticks=1,indicator-clusters=1',
    '--joystick', mappingFile(device));
  await boots;
  await seat.says(/is 'stick of a test'/);
  const host = new Host(bus);
  await host.configure();
  await host.sees('everything at rest', 0, 0, 0);
  console.log('node-canopen has mapped and enabled the PDO, and receives it');

  stick.does(`abs ${ABS_X} 1023`, `abs ${ABS_Y} 1023`, 'report');
  await host.sees('both axes at their ends', 32767, -32768, 0);
  // Half of the 400 that the dead band leaves; and within it.
  stick.does(`abs ${ABS_X} 0`, `abs ${ABS_Y} 212`, 'report');
  await host.sees('x at its other end, y half of the way', -32768, 16384, 0);
  stick.does(`abs ${ABS_Y} 612`, 'report');
  await host.sees('y in its dead band', -32768, 0, 0);

  // Pressed and released before anybody could look: both are told, once.
  const from = bus.heard.length;
  const press = [`key ${BTN_TRIGGER} 1`, 'report', `key ${BTN_TRIGGER} 0`, 'report'];
  stick.does(...press, ...press, `abs ${ABS_X} 512`, 'report');
  await host.sees('x in the centre', 0, 0, 0);
  const told = bus.heard.slice(from).filter(({id}) => id === PDO).map(({data}) => data.toString('hex'));
  assert.deepStrictEqual(told, ['0080000004', '0080000000', '0080000004', '0080000000', '0000000000']);
  console.log('each press is told once, however short');

  await host.write(0x6200, 1, 0x02, DataType.UNSIGNED8);
  await stick.says(`led ${LED_MUTE} 1`);
  await seat.says(/indicator 2 of cluster 1 on/);

  stick.does(`abs ${ABS_X} 1023`, `key ${BTN_TRIGGER} 1`, 'report');
  await host.sees('moved and pressed', 32767, 0, 4);
  stick.does('unplug');
  await host.sees('at rest without the stick', 0, 0, 0);
  await within('emergency 7000h', () => host.emergencies.at(-1) === 0x7000);
  await seat.says(/is gone/);
  const lights = stick.lines.filter((line) => line.startsWith('led')).length;
  stick.does('plug');
  assert.strictEqual(await stick.says('device', 2), device);
  await within('no error', () => host.emergencies.at(-1) === 0);
  await within('its light on again', () => stick.lines.slice(lights).includes(`led ${LED_MUTE} 1`));
  stick.does(`abs ${ABS_X} 1023`, 'report');
  await host.sees('the stick that is back', 32767, 0, 0);
  console.log('an unplugged stick is at rest, and back again');

  host.device.stop();
  await seat.end();
  bus.close();
}

main().then(() => process.exit(0), (error) => {
  console.error(error);
  process.exit(1);
});
