'use strict';

// node-canopen loads the data sheets that canvoy writes. What is expected in them is typed from the specifications.
//
//     node tests/strangers/eds/eds_test.js COMMAND

const assert = require('assert');
const {spawnSync} = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');

const {AccessType, DataType, Eds} = require('canopen');

const command = process.argv[2];
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'canvoy-eds-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true}));

function load(...device) {
  const file = path.join(folder, 'device.eds');
  const {status, stderr} = spawnSync(command, ['eds', 'export', ...device, '--out', file], {encoding: 'utf8'});
  assert.strictEqual(status, 0, stderr);
  return Eds.fromFile(file);
}

function assertEntry(entry, expected) {
  assert.ok(entry, JSON.stringify(expected));
  for (const [key, value] of Object.entries(expected)) assert.strictEqual(entry[key], value, `${entry}: ${key}`);
}

const charger = load('charger');
assertEntry(charger.getEntry(0x1000), {value: 0x1a3, accessType: AccessType.READ_ONLY});
assertEntry(charger.getEntry(0x6010), {
  parameterName: 'battery_temperature', dataType: DataType.INTEGER16, accessType: AccessType.READ_WRITE, pdoMapping: '1',
});
assertEntry(charger.getSubEntry(0x1600, 1), {value: 0x60100010});

// CiA 407, 6.3 and 6.4: an identification device, and a destination indicator with text.
assertEntry(load('407', '--device', '02').getEntry(0x6191), {dataType: DataType.UNSIGNED32});
const indicator = load('407', '--device', '03', '--class', '1', '--subclass', '2');
assertEntry(indicator.getEntry(0x6191), {parameterName: 'destination_number', accessType: AccessType.WRITE_ONLY});
assert.ok(!indicator.getEntry(0x6109), 'stop_point_ID is none of its objects');

// CiA 417-4: the statusword and position of four doors.
const door = load('417-4', '--device', '05');
assertEntry(door.getEntry(0x1000), {value: 0x050001a1});
assertEntry(door.getSubEntry(0x6301, 1), {dataType: DataType.UNSIGNED16});

// All virtual devices of all profiles, with all that is optional.
for (const profile of ['407', '417-4', '447-3', '852']) {
  const {stdout} = spawnSync(command, ['profile', profile, '--json'], {encoding: 'utf8', maxBuffer: 1 << 28});
  const lines = stdout.trim().split('\n').map((line) => JSON.parse(line));
  const devices = new Set(lines.filter(({kind}) => kind === 'device').map(
    (line) => JSON.stringify([line.device, line.class, line.subclass])));
  assert.ok(devices.size > 0);
  for (const device of devices) {
    const [name, deviceClass, subclass] = JSON.parse(device);
    const eds = load(profile, '--device', name, '--class', `${deviceClass}`, '--subclass', `${subclass}`, '--optional');
    assert.ok([...eds.keys()].length >= 4, name);
  }
}
