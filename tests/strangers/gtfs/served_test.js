'use strict';

// What `canvoy run bus --gtfs-rt` says of a bus that drives the feed of the npm package sample-gtfs-feed, in a file and by
// HTTP: asked for by the HTTP client of Node.js, and read by gtfs-realtime-bindings.
//
//     node tests/strangers/gtfs/served_test.js COMMAND

const assert = require('assert');
const fs = require('fs');
const os = require('os');
const path = require('path');
const {execFileSync, spawn} = require('child_process');

const COMMAND = process.argv[2];
let sample;
let realtime;
try {
  sample = path.dirname(require.resolve('sample-gtfs-feed/package.json'));
  realtime = require('gtfs-realtime-bindings').transit_realtime;
} catch (missing) {
  console.log(`skipped: ${missing.message.split('\n')[0]}; scripts/install-packages test installs it`);
  process.exit(77);
}
const stops = require('sample-gtfs-feed/json/stops.json');
const agency = require('sample-gtfs-feed/json/agency.json')[0];
const LINE = ['run', 'bus', '--gtfs', path.join(sample, 'gtfs'), '--route', 'A', '--json'];

const decode = (bytes) =>
  realtime.FeedMessage.toObject(realtime.FeedMessage.decode(bytes), {enums: String, longs: Number});

// The clock on a wall of the agency's town.
function localTime(seconds) {
  return new Date(seconds * 1000).toLocaleString('sv-SE', {timeZone: agency.agency_timezone});
}

function check(message, now) {
  assert.strictEqual(message.header.gtfsRealtimeVersion, '2.0');
  const {vehicle} = message.entity.find((each) => each.vehicle);
  assert.strictEqual(vehicle.trip.routeId, 'A');
  assert.ok(stops.some((each) => each.stop_id === vehicle.stopId), vehicle.stopId);
  // No stop of the feed is farther away.
  const near = Math.min(...stops.map((each) =>
    Math.hypot(each.stop_lat - vehicle.position.latitude, each.stop_lon - vehicle.position.longitude)));
  assert.ok(near < 0.2, `${near} degrees from the nearest stop`);
  assert.match(vehicle.occupancyStatus, /^[A-Z_]+$/);
  const update = message.entity.find((each) => each.tripUpdate).tripUpdate;
  assert.deepStrictEqual(update.trip, vehicle.trip);
  if (now) {
    const late = Date.parse(`${now.replace(' ', 'T')}Z`) - Date.parse(`${localTime(message.header.timestamp).replace(' ', 'T')}Z`);
    assert.ok(late >= 0 && late <= 15000, `it is ${now}, and told was ${localTime(message.header.timestamp)}`);
  }
  return message.header.timestamp;
}

function fromFile() {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'gtfs-rt-'));
  const file = path.join(folder, 'realtime.pb');
  const lines = execFileSync(COMMAND, [...LINE, '--for', '20min', '--gtfs-rt', file], {encoding: 'utf8', maxBuffer: 1 << 26});
  const last = lines.trim().split('\n').map((line) => JSON.parse(line)).filter((each) => each.event === 'snapshot').pop();
  check(decode(fs.readFileSync(file)), last.local_time);
  fs.rmSync(folder, {recursive: true});
}

async function ask(url) {
  const response = await fetch(url);
  assert.strictEqual(response.status, 200);
  assert.strictEqual(response.headers.get('content-type'), 'application/x-protobuf');
  const bytes = Buffer.from(await response.arrayBuffer());
  assert.strictEqual(response.headers.get('content-length'), String(bytes.length));
  return decode(bytes);
}

async function byHttp() {
  const bus = spawn(COMMAND, [...LINE, '--speed', '60', '--gtfs-rt', '127.0.0.1:0'], {stdio: ['ignore', 'ignore', 'pipe']});
  const told = await new Promise((resolve) => bus.stderr.once('data', resolve));
  const [url] = String(told).match(/http:\S+/);
  // Before anything was heard of the bus there is no vehicle.
  let message = await ask(url);
  for (const end = Date.now() + 60000; (message.entity ?? []).length < 2 && Date.now() < end;) message = await ask(url);
  const first = check(message);
  let later = first;
  for (const end = Date.now() + 60000; later < first + 60 && Date.now() < end;) {
    later = check(await ask(`${url}gtfs-realtime/vehicle-positions`));
  }
  assert.ok(later >= first + 60, `${first}, then ${later}`);
  const over = new Promise((resolve) => bus.once('exit', resolve));
  bus.kill('SIGTERM');
  assert.strictEqual(await over, 0);
}

fromFile();
byHttp().then(() => console.log('GTFS-Realtime from a file and by HTTP: as others read it'), (error) => {
  console.error(error);
  process.exit(1);
});
