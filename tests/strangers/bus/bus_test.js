'use strict';

// A bus whose ticket canceller is a stranger: node-canopen, on a real CAN interface. It has our data sheet, is started by
// our on-board computer, takes the messages of the typical configuration (CiA 407, 8.1.4.3), and reads a text of 128
// octets of the on-board computer by SDO (5.2). candump listens, and each frame of its log has a name.
//
//     node tests/strangers/bus/bus_test.js COMMAND FOLDER
//
// COMMAND is canvoy; candump.log is left in FOLDER.

const assert = require('assert');
const {spawnSync} = require('child_process');
const fs = require('fs');
const http = require('http');
const path = require('path');
const {DataType, Device, Eds} = require('canopen');
const {CanBus, SPEAKERS} = require('../charging/can_bus');
const {assertDecodes} = require('../charging/logs');
const {Program} = require('../charging/program');

const [command, folder] = process.argv.slice(2);
const BUS = 'vcan0';
const CANCELLER = 6;
const COMPUTER = 1;
const TIME_OUT_MS = 60000;
const PATIENCE_MS = 90000;
const HEADSIGN = 'Bahnhof ' + 'über die Brücke '.repeat(12); // more than 128 octets

// One journey at 8:00 on a Monday, between two stops, in zone 3.
const FEED = {
  'agency.txt': 'agency_id,agency_name,agency_url,agency_timezone\nA,Town,http://town.example,Europe/Berlin\n',
  'stops.txt': 'stop_id,stop_name,stop_lat,stop_lon,zone_id\nS1,Hafen,50.1000,8.5000,3\nS2,Bahnhof,50.1050,8.5000,3\n',
  'routes.txt': 'route_id,agency_id,route_short_name,route_long_name,route_type\nR23,A,23,,3\n',
  'trips.txt': `route_id,service_id,trip_id,trip_headsign,direction_id\nR23,W,T1,${HEADSIGN},0\n`,
  'stop_times.txt':
    'trip_id,arrival_time,departure_time,stop_id,stop_sequence\nT1,08:00:00,08:00:00,S1,1\nT1,08:03:00,08:03:00,S2,2\n',
  'calendar.txt':
    'service_id,monday,tuesday,wednesday,thursday,friday,saturday,sunday,start_date,end_date\n' +
    'W,1,1,1,1,1,0,0,20261102,20261231\n',
};

const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

function canvoy(...options) {
  const {status, stdout, stderr} = spawnSync(command, options, {encoding: 'utf8', maxBuffer: 1 << 26});
  assert.strictEqual(status, 0, stderr);
  return stdout;
}

async function listen() {
  const bus = new CanBus(BUS, path.join(folder, 'candump.log'));
  // candump hears nothing until its socket is open.
  for (let tries = 0; tries < 100 && bus.heard.length === 0; ++tries) {
    bus.throwIn('7FF#');
    await sleep(200);
  }
  return bus;
}

function networkFile() {
  const feed = path.join(folder, 'feed');
  fs.mkdirSync(feed);
  for (const [name, text] of Object.entries(FEED)) fs.writeFileSync(path.join(feed, name), text);
  const changes = [
    ['# real = "can0"', `real = "${BUS}"`],
    ['[ticket-canceller]  # node 6\nplayed = true', '[ticket-canceller]\nplayed = false'],
  ];
  let text = canvoy('run', 'bus', '--gtfs', feed, '--route', '23', '--print');
  for (const [from, to] of changes) {
    assert.ok(text.includes(from), text);
    text = text.replace(from, to);
  }
  const file = path.join(folder, 'bus.toml');
  fs.writeFileSync(file, text);
  return file;
}

function stranger(bus) {
  const sheet = path.join(folder, 'canceller.eds');
  canvoy('eds', 'export', 'ticket-canceller', '--out', sheet);
  const eds = Eds.fromFile(sheet);
  eds.addSdoClientParameter(COMPUTER, 0x600 + COMPUTER, 0x580 + COMPUTER);
  const device = new Device({id: CANCELLER, eds});
  device.on('message', ({id, data}) => bus.send(id, data || Buffer.alloc(0)));
  bus.on('frame', (frame) => {
    if (frame.id === null || frame.remote) return;
    setImmediate(() => device.receive({id: frame.id, data: frame.data, len: frame.data.length}));
  });
  device.start();
  return device;
}

async function until(what, isSo) {
  const giveUp = Date.now() + PATIENCE_MS;
  while (!isSo()) {
    assert.ok(Date.now() < giveUp, `${what} did not come`);
    await sleep(20);
  }
}

// Line 1 of the feed, the first of its blocks and journeys; the bus waits at its first stop since 7:55.
async function takesTheMessages(device) {
  const value = (index, sub = 0) => {
    const object = device.eds.getEntry(index);
    return sub === 0 ? object.value : object.at(sub).value;
  };
  await until('operational', () => device.nmt.state === 5);
  // 610Eh: years since 1985, quarters of days, month, hour, minute.
  await until('the time', () => value(0x610E, 4) === 7 && value(0x610E, 5) >= 55);
  assert.deepStrictEqual([1, 2, 3].map((sub) => value(0x610E, sub)), [41, 2 * 4, 11]);
  await until('the fare zone', () => value(0x6111) === 3);
  assert.strictEqual(value(0x6116), 0, 'tickets are not blocked');
  assert.strictEqual(value(0x610A), 1, 'the first stop of the route');
  await until('the block', () => value(0x6194) === 1);
  assert.strictEqual(value(0x6192), 23);
}

async function readsAText(device) {
  const request = {deviceId: COMPUTER, index: 0x610C, subIndex: 1, dataType: DataType.DOMAIN, timeout: TIME_OUT_MS};
  let octets = Buffer.alloc(0);
  const giveUp = Date.now() + PATIENCE_MS;
  while (octets.length === 0) {
    assert.ok(Date.now() < giveUp, 'no text came');
    octets = await device.sdo.upload(request).then((read) => Buffer.from(read ?? []), () => Buffer.alloc(0));
    await sleep(50);
  }
  const whole = Buffer.from(`23 to ${HEADSIGN}`, 'latin1');
  assert.strictEqual(octets.length, 128);
  assert.ok(whole.subarray(0, 128).equals(octets), octets.toString('latin1'));
}

// The status and the body. Node.js' own fetch wants a compiler, which it has none of here.
function get(url, token) {
  return new Promise((resolve, reject) => {
    http.get(url, {headers: {Authorization: `Bearer ${token}`}}, (response) => {
      let body = '';
      response.on('data', (text) => (body += text)).on('end', () => resolve({status: response.statusCode, body}));
    }).on('error', reject);
  });
}

// The page of the same socket: who is there, and no leave to send anything.
async function isViewed() {
  const view = new Program([], command, 'view', BUS, '--profile', '407');
  await view.says(/\n/);
  const [url, token] = view.out.trim().split('?token=');
  const operational = async () => {
    const nodes = JSON.parse((await get(`${url}api/nodes`, token)).body);
    return nodes.filter(({state}) => state === 'operational').map(({node}) => node);
  };
  const giveUp = Date.now() + PATIENCE_MS;
  for (let there = []; !(there.includes(COMPUTER) && there.includes(CANCELLER)); there = await operational()) {
    assert.ok(Date.now() < giveUp, `operational: ${there}`);
    await sleep(100);
  }
  assert.strictEqual((await get(`${url}api/networks/${BUS}/nodes/${CANCELLER}/objects/1000`, token)).status, 405);
  await view.end();
}

// PDOs that are not pre-defined (8.1.5) have the names of the connection set alone.
const SERVICES = ['NMT', 'PDO', 'TPDO1', 'TPDO2', 'TPDO3', 'SDO request', 'SDO response', 'heartbeat', 'boot-up', 'EMCY'];

async function main() {
  const bus = await listen();
  const device = stranger(bus);
  const vehicle = new Program(SPEAKERS, command, 'run', networkFile(), '--for', '1h');
  await takesTheMessages(device);
  console.log('node-canopen takes the messages of the typical configuration');
  await readsAText(device);
  console.log('and reads a text of 128 octets');
  await isViewed();
  console.log('canvoy view shows both, and sends nothing');
  device.stop();
  vehicle.child.kill('SIGTERM');
  await vehicle.status;
  bus.close();
  const frames = assertDecodes(command, path.join(folder, 'candump.log'), '407', SERVICES);
  console.log(`${frames} frames of candump have a name`);
}

main().then(() => process.exit(0), (error) => {
  console.error(error);
  process.exit(1);
});
