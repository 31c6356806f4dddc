'use strict';

// Our reader of GTFS against the data that the npm package sample-gtfs-feed was made of, from its folder and its zip file;
// and our realtime feed against gtfs-realtime-bindings, the reader that the makers of the format publish.
//
//     node tests/strangers/gtfs/gtfs_test.js PEER
//
// PEER is the program of peer.cpp.

const assert = require('assert');
const path = require('path');
const {execFileSync, spawnSync} = require('child_process');

const PEER = process.argv[2];
let sample;
let realtime;
try {
  sample = path.dirname(require.resolve('sample-gtfs-feed/package.json'));
  realtime = require('gtfs-realtime-bindings').transit_realtime;
} catch (missing) {
  console.log(`skipped: ${missing.message.split('\n')[0]}; scripts/install-packages test installs it`);
  process.exit(77);
}
const table = (name) => require(`sample-gtfs-feed/json/${name}.json`);

const FIRST = '20190225';
const DAYS = 200;

function seconds(text) {
  if (!text) return null;
  const [hours, minutes, rest] = text.split(':').map(Number);
  return hours * 3600 + minutes * 60 + rest;
}

function dayText(offset) {
  return new Date(Date.UTC(2019, 1, 25 + offset)).toISOString().slice(0, 10).replaceAll('-', '');
}

// By calendar.txt and calendar_dates.txt, looked at day by day.
function runsOn(service, offset) {
  const date = dayText(offset);
  const exception = table('calendar_dates').find((each) => each.service_id === service && each.date === date);
  if (exception) return exception.exception_type === '1';
  const days = table('calendar').find((each) => each.service_id === service);
  const names = ['monday', 'tuesday', 'wednesday', 'thursday', 'friday', 'saturday', 'sunday'];
  return days !== undefined && days.start_date <= date && date <= days.end_date && days[names[offset % 7]] === '1';
}

function expectedTrip(trip) {
  const calls = table('stop_times').filter((each) => each.trip_id === trip.trip_id)
    .sort((a, b) => a.stop_sequence - b.stop_sequence)
    .map((each) => ({
      stop: each.stop_id, sequence: Number(each.stop_sequence), arrival: seconds(each.arrival_time ?? each.departure_time),
      departure: seconds(each.departure_time ?? each.arrival_time),
    }));
  const frequencies = table('frequencies').filter((each) => each.trip_id === trip.trip_id)
    .map((each) => [seconds(each.start_time), seconds(each.end_time), each.headway_secs]);
  const shape = table('shapes').filter((each) => each.shape_id === trip.shape_id)
    .sort((a, b) => a.shape_pt_sequence - b.shape_pt_sequence)
    .map((each) => [each.shape_pt_lat, each.shape_pt_lon, each.shape_dist_traveled]);
  return {id: trip.trip_id, headsign: trip.trip_headsign ?? '', service: trip.service_id, calls, frequencies, shape};
}

const byId = (a, b) => (a.id < b.id ? -1 : 1);

function checkRoute(feed, route) {
  const trips = table('trips').filter((each) => each.route_id === route.route_id);
  const expected = trips.map(expectedTrip).sort(byId);
  assert.ok(expected.length > 0);
  const read = JSON.parse(execFileSync(PEER, ['feed', feed, route.route_id, FIRST, String(DAYS)]));
  assert.deepStrictEqual(read.trips.sort(byId), expected);
  assert.strictEqual(read.route, route.route_short_name);
  assert.strictEqual(read.agency, table('agency').find((each) => each.agency_id === route.agency_id).agency_name);
  assert.strictEqual(read.version, table('feed_info').feed_version);
  const used = new Set(expected.flatMap((trip) => trip.calls.map((call) => call.stop)));
  assert.deepStrictEqual(read.stops.sort(byId), table('stops').filter((each) => used.has(each.stop_id))
    .map((each) => ({id: each.stop_id, code: each.stop_code ?? '', name: each.stop_name, at: [each.stop_lat, each.stop_lon]}))
    .sort(byId));
  for (let day = 0; day < DAYS; ++day) {
    const running = trips.filter((trip) => runsOn(trip.service_id, day)).map((trip) => trip.trip_id);
    assert.deepStrictEqual(read.running[day].sort(), running.sort(), dayText(day));
  }
}

for (const feed of [path.join(sample, 'gtfs'), path.join(sample, 'gtfs.zip')]) {
  for (const route of table('routes')) checkRoute(feed, route);
  const wrong = spawnSync(PEER, ['feed', feed, 'X', FIRST, '1'], {encoding: 'utf8'});
  assert.strictEqual(wrong.status, 1);
  assert.match(wrong.stderr, /^[^\n]+routes\.txt: no route 'X'; there are A \(Ada\), B \(Babbage\)[^\n]+\n$/);
}

const message = realtime.FeedMessage.decode(execFileSync(PEER, ['realtime']));
const read = realtime.FeedMessage.toObject(message, {enums: String, longs: Number});
const trip = {tripId: 't1', startTime: '24:05:00', startDate: '20261123', routeId: '42', directionId: 1};
assert.deepStrictEqual(read, {
  header: {gtfsRealtimeVersion: '2.0', incrementality: 'FULL_DATASET', timestamp: 1795449600},
  entity: [
    {
      id: 'trip-t1-20261123-24:05:00',
      tripUpdate: {
        trip,
        vehicle: {id: 'bus-7', label: '7'},
        stopTimeUpdate: [
          {stopSequence: 2, stopId: 'a', departure: {delay: -30}},
          {stopSequence: 5, stopId: 'b', arrival: {delay: 125}, departure: {delay: 0}},
          {stopSequence: 6, stopId: 'c', scheduleRelationship: 'SKIPPED'},
        ],
        timestamp: 1795449598,
        delay: -30,
      },
    },
    {
      id: 'vehicle-bus-7',
      vehicle: {
        trip,
        vehicle: {id: 'bus-7', label: '7'},
        position: {latitude: 50.125, longitude: -8.5, bearing: 270, odometer: 123456.75, speed: 12.5},
        currentStopSequence: 300,
        stopId: 'mühle',
        currentStatus: 'IN_TRANSIT_TO',
        timestamp: 1795449599,
        occupancyStatus: 'STANDING_ROOM_ONLY',
        occupancyPercentage: 180,
      },
    },
    {id: 'vehicle-bus-8', vehicle: {vehicle: {id: 'bus-8'}, position: {latitude: 0, longitude: 0}}},
  ],
});
console.log('GTFS and GTFS-Realtime: as others read them');
