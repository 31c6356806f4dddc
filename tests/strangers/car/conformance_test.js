'use strict';

// All 16 nodes of a car, asked by node-canopen whether they are what their data sheets say (after CiA 310): that they
// boot up and are heard; each object with its length, access and limits; that what is read may be written back; that
// what does not exist, is too long or too short, or may not be written, is refused with its abort code; that what PDOs
// carry exists. It lists all errors, and ends with 1 where there is one.
//
//     node tests/strangers/car/conformance_test.js PEER COMMAND

const assert = require('assert');
const {spawnSync} = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');
const {AccessType, DataType, Device, Eds} = require('canopen');
const {Wire, run} = require('../wire');

const NODES = 16;
const TESTER = 100; // no node of the car
const PROFILE = 447;
const TIME_OUT_MS = 30000;
const ERROR_HISTORY = 0x1003;
const STORAGE = [0x1010, 0x1011];

const WRITE_ONLY = 0x06010001; // abort codes of CiA 301
const READ_ONLY = 0x06010002;
const UNSUPPORTED_ACCESS = 0x06010000;
const NO_OBJECT = 0x06020000;
const WRONG_LENGTH = 0x06070010;
const TOO_LONG = 0x06070012;
const TOO_SHORT = 0x06070013;
const NO_SUB_INDEX = 0x06090011;
const TOO_HIGH = 0x06090031;
const TOO_LOW = 0x06090032;
const NO_DATA = 0x08000024;
const INVALID_VALUE = 0x06090030;
const LOCAL_CONTROL = 0x08000021;
const DEVICE_STATE = 0x08000022;

const SIZES = new Map([
  [DataType.BOOLEAN, 1], [DataType.INTEGER8, 1], [DataType.INTEGER16, 2], [DataType.INTEGER24, 3],
  [DataType.INTEGER32, 4], [DataType.INTEGER40, 5], [DataType.INTEGER48, 6], [DataType.INTEGER64, 8],
  [DataType.UNSIGNED8, 1], [DataType.UNSIGNED16, 2], [DataType.UNSIGNED24, 3], [DataType.UNSIGNED32, 4],
  [DataType.UNSIGNED40, 5], [DataType.UNSIGNED48, 6], [DataType.UNSIGNED64, 8], [DataType.REAL32, 4],
  [DataType.REAL64, 8],
]);

const [peer, command] = process.argv.slice(2);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'canvoy-conformance-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true}));

const hex = (number, digits) => number.toString(16).toUpperCase().padStart(digits, '0');
const oneOf = (...codes) => (code) => codes.includes(code);
const isMapping = (index) => index >= 0x1600 && index < 0x1800 || index >= 0x1A00 && index < 0x1C00;
// What a sealed device takes from its provider alone (the stranger is none), and in service mode alone (MID, annex IX).
const CLOCKS = [0x60F0, 0x60F2, 0x60F4];
const SEALED = new Map([
  ['taximeter', [0x6050, 0x6051, 0x6052, 0x6053, 0x6054, 0x6055, 0x6056, 0x6057, ...CLOCKS]],
  ['driver-identification', CLOCKS],
]);
const isSealed = (device, index) => (SEALED.get(device) ?? []).includes(index);
const isForService = (device, index) => device === 'taximeter' && index >= 0x1200 && index < 0x1800;
const isWritable = (entry) => [AccessType.READ_WRITE, AccessType.WRITE_ONLY, 'rwr', 'rww'].includes(entry.accessType);

function sheetOf(device) {
  const file = path.join(folder, `${device}.eds`);
  const {status, stderr} = spawnSync(command, ['eds', 'export', device, '--out', file], {encoding: 'utf8'});
  assert.strictEqual(status, 0, stderr);
  return Eds.fromFile(file);
}

// All entries that have a value: variables, and the elements of arrays and records.
function* entriesOf(eds) {
  for (const object of eds.values()) {
    if (!object.subNumber) yield {index: object.index, subIndex: 0, entry: object};
    for (let subIndex = 0; object.subNumber && subIndex < 256; subIndex++) {
      const entry = object.at(subIndex);
      if (entry) yield {index: object.index, subIndex, entry};
    }
  }
}

class Examination {
  constructor(wire, client, id, device) {
    Object.assign(this, {wire, client, id, device, eds: sheetOf(device), checks: 0, errors: []});
  }

  // The abort code of a transfer; 0 where it succeeds. Time goes on with each.
  async codeOf(transfer) {
    const code = transfer.then(() => 0, (error) => error.code ?? assert.fail(error));
    await this.wire.until('an answer', () => this.isAnswered(transfer));
    return code;
  }
  isAnswered(transfer) {
    if (!transfer.watched) {
      transfer.watched = true;
      const done = () => { transfer.done = true; };
      transfer.then(done, done);
    }
    return transfer.done;
  }
  request(index, subIndex) {
    return {deviceId: this.id, index, subIndex, timeout: TIME_OUT_MS};
  }
  read(index, subIndex) {
    return this.client.sdo.upload(this.request(index, subIndex));
  }
  write(index, subIndex, data) {
    return this.client.sdo.download({...this.request(index, subIndex), data});
  }
  check(index, subIndex, what, isRight, found) {
    this.checks += 1;
    if (isRight) return;
    const shown = typeof found === 'number' ? hex(found, 8) : found;
    this.errors.push(`node ${this.id} ${this.device}: ${hex(index, 4)}:${hex(subIndex, 2)} ${what}: ${shown}`);
  }
  async expect(index, subIndex, what, transfer, isRight) {
    const code = await this.codeOf(transfer);
    this.check(index, subIndex, what, isRight(code), code);
    return code;
  }

  async examine() {
    await this.examineIdentity();
    for (const {index, subIndex, entry} of entriesOf(this.eds)) await this.examineEntry(index, subIndex, entry);
    await this.examineWhatIsMissing();
    await this.examinePdos();
  }

  async examineIdentity() {
    const bootUp = `${hex(0x700 + this.id, 3)}#00`;
    this.check(0x1017, 0, 'boot-up message', this.wire.heard.includes(bootUp), 'none');
    const beats = this.wire.heard.filter((line) => line === `${hex(0x700 + this.id, 3)}#05`).length;
    this.check(0x1017, 0, 'heartbeat each second of an operational node', beats >= 3, `${beats} in 5 s`);
    for (const index of [0x1000, 0x1001, 0x1018]) {
      this.check(index, 0, 'mandatory object', this.eds.getEntry(index) !== undefined, 'not in the data sheet');
    }
    const type = this.read(0x1000, 0);
    await this.expect(0x1000, 0, 'read', type, oneOf(0));
    this.check(0x1000, 0, 'profile', (await type).readUInt16LE(0) === PROFILE, (await type).toString('hex'));
  }

  async examineEntry(index, subIndex, entry) {
    const size = SIZES.get(entry.dataType);
    if (entry.accessType === AccessType.WRITE_ONLY) {
      await this.expect(index, subIndex, 'read of a write-only entry', this.read(index, subIndex), oneOf(WRITE_ONLY));
      return;
    }
    const reading = this.read(index, subIndex);
    const code = await this.codeOf(reading);
    if (code !== 0) {
      const mayHaveNone = index === ERROR_HISTORY || entry.dataType === DataType.DOMAIN;
      this.check(index, subIndex, 'read', code === NO_DATA && mayHaveNone, code);
      return;
    }
    const value = await reading;
    if (size !== undefined) this.check(index, subIndex, `${size} bytes`, value.length === size, `${value.length} bytes`);
    if (!isWritable(entry)) {
      await this.expect(index, subIndex, 'write of a read-only entry', this.write(index, subIndex, value),
        oneOf(READ_ONLY));
      return;
    }
    if (size === undefined || STORAGE.includes(index)) return;
    await this.examineWriting(index, subIndex, entry, value);
  }

  async examineWriting(index, subIndex, entry, value) {
    await this.expect(index, subIndex, `write of what was read, ${value.toString('hex')}`,
      this.write(index, subIndex, value), oneOf(this.codeOfWriting(index)));
    await this.expect(index, subIndex, 'a byte too many',
      this.write(index, subIndex, Buffer.concat([value, Buffer.alloc(1)])), oneOf(TOO_LONG, WRONG_LENGTH));
    if (value.length > 1) {
      await this.expect(index, subIndex, 'a byte too few', this.write(index, subIndex, value.subarray(1)),
        oneOf(TOO_SHORT, WRONG_LENGTH));
    }
    const isShort = value.length < 5;
    for (const [limit, step, wanted] of [[entry.highLimit, 1, TOO_HIGH], [entry.lowLimit, -1, TOO_LOW]]) {
      if (limit === undefined || !isShort || limit + step < 0 || limit + step >= 2 ** (8 * value.length)) continue;
      const beyond = Buffer.alloc(value.length);
      beyond.writeUIntLE(limit + step, 0, value.length);
      await this.expect(index, subIndex, `${limit + step} is beyond its limit`, this.write(index, subIndex, beyond),
        isSealed(this.device, index) ? oneOf(wanted, INVALID_VALUE) : oneOf(wanted));
    }
  }
  codeOfWriting(index) {
    if (isSealed(this.device, index)) return LOCAL_CONTROL;
    if (isForService(this.device, index)) return DEVICE_STATE;
    // The mapping of a PDO that is valid stays as it is (CiA 301).
    return isMapping(index) ? UNSUPPORTED_ACCESS : 0;
  }

  async examineWhatIsMissing() {
    for (const index of [0x0000, 0x1FFF, 0x2000, 0x5FFF, 0x67FF, 0x9FFF, 0xFFFF]) {
      if (this.eds.getEntry(index) !== undefined) continue;
      await this.expect(index, 0, 'no such object', this.read(index, 0), oneOf(NO_OBJECT));
    }
    for (const object of this.eds.values()) {
      const last = object.subNumber ? Math.max(...[...Array(256).keys()].filter((sub) => object.at(sub))) : 0;
      if (last === 0xFF) continue;
      await this.expect(object.index, last + 1, 'no such sub-index', this.read(object.index, last + 1),
        oneOf(NO_SUB_INDEX));
    }
  }

  // Each mapped object exists, may be mapped, and has the length that the mapping says.
  async examinePdos() {
    for (const object of this.eds.values()) {
      if (!isMapping(object.index)) continue;
      const count = (await this.answerOf(object.index, 0)).readUInt8(0);
      let bits = 0;
      for (let i = 1; i <= count; i++) {
        const mapped = (await this.answerOf(object.index, i)).readUInt32LE(0);
        bits += mapped & 0xFF;
        const found = this.eds.getEntry(mapped >>> 16);
        const entry = found?.subNumber ? found.at(mapped >>> 8 & 0xFF) : found;
        this.check(object.index, i, 'mapped object', entry !== undefined || (mapped >>> 16) < 0x20, mapped);
        if (!entry) continue;
        this.check(object.index, i, 'may be mapped', entry.pdoMapping == true, mapped); // eslint-disable-line eqeqeq
        const size = SIZES.get(entry.dataType);
        this.check(object.index, i, 'length of the mapped object', size * 8 === (mapped & 0xFF), mapped);
      }
      this.check(object.index, 0, 'at most 64 bits', bits <= 64, `${bits} bits`);
    }
  }
  async answerOf(index, subIndex) {
    const reading = this.read(index, subIndex);
    await this.expect(index, subIndex, 'read', reading, oneOf(0));
    return reading;
  }
}

async function main() {
  const wire = new Wire(peer);
  const eds = new Eds();
  for (let id = 1; id <= NODES; id++) eds.addSdoClientParameter(id, 0x600 + id, 0x580 + id);
  const client = new Device({id: TESTER, eds});
  wire.connect(client);
  client.start();
  await wire.runUntil(5000);
  const devices = wire.heard.filter((line) => line.startsWith('device ')).map((line) => line.split(' '));
  assert.strictEqual(devices.length, NODES);
  let checks = 0;
  const errors = [];
  for (const [, id, device] of devices) {
    const examination = new Examination(wire, client, Number(id), device);
    await examination.examine();
    console.log(`node ${id} ${device}: ${examination.checks} checks, ${examination.errors.length} errors`);
    errors.push(...examination.errors);
    checks += examination.checks;
  }
  client.stop();
  await wire.end();
  for (const error of errors) console.log(error);
  console.log(`${checks} checks, ${errors.length} errors`);
  assert.ok(checks > 1000);
  assert.strictEqual(errors.length, 0);
}

run(main);
