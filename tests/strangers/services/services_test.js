'use strict';

// TIME and emergencies between node-canopen and a node of ours, both ways.
//
//     node tests/strangers/services/services_test.js PEER
//
// PEER is the program of peer.cpp.

const assert = require('assert');
const {Device, Eds} = require('canopen');
const {Wire, run} = require('../wire');

const WAIT_MS = 30000;
const NOON = Date.UTC(2026, 10, 21, 12, 0, 0, 250);
const DAYS = 15665; // from 1 January 1984 to 21 November 2026
const MILLISECONDS = 12 * 3600 * 1000 + 250;

// Resolves with what the first event carries for which `wanted` holds.
function next(emitter, event, wanted = () => true) {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error(`no ${event} within ${WAIT_MS} ms`)), WAIT_MS);
    const look = (what) => {
      if (!wanted(what)) return;
      clearTimeout(timer);
      emitter.off(event, look);
      resolve(what);
    };
    emitter.on(event, look);
  });
}

class Network extends Wire {
  constructor(peer) {
    super(peer);
    const eds = new Eds();
    eds.setTimeCobId(0x100);
    eds.setTimeProducerEnable(true);
    eds.setTimeConsumerEnable(true);
    eds.setEmcyCobId(0x81);
    eds.setErrorRegister(0x09);
    eds.addEmcyConsumer(0x85);
    this.device = new Device({id: 1, eds});
    this.connect(this.device);
  }
}

async function tellsTime(network) {
  const heard = network.hears(`time ${DAYS} ${MILLISECONDS}`);
  network.device.time.write(new Date(NOON));
  await heard;
}

async function hearsTime(network) {
  const heard = next(network.device.time, 'time');
  network.tell(`clock ${DAYS} ${MILLISECONDS}`);
  network.tell('tell');
  assert.strictEqual((await heard).getTime(), NOON);
}

async function tellsAnEmergency(network) {
  const heard = network.hears('emergency 1 4210 09 0102030405');
  network.device.emcy.write(0x4210, Buffer.from([1, 2, 3, 4, 5]));
  await heard;
}

async function hearsAnEmergencyComeAndGo(network) {
  const comes = next(network.device.emcy, 'emergency');
  network.tell('raise 4310');
  const raised = await comes;
  assert.strictEqual(raised.cobId, 0x85);
  assert.strictEqual(raised.em.code, 0x4310);
  assert.strictEqual(raised.em.register, 0x09);
  const goes = next(network.device.emcy, 'emergency');
  network.tell('clear 4310');
  const cleared = await goes;
  assert.strictEqual(cleared.em.code, 0);
  assert.strictEqual(cleared.em.register, 0);
}

async function main() {
  const network = new Network(process.argv[2]);
  await network.hears('705#00');
  network.device.start();
  network.device.nmt.startNode();
  for (const test of [tellsTime, hearsTime, tellsAnEmergency, hearsAnEmergencyComeAndGo]) {
    await test(network);
    console.log(`${test.name} passed`);
  }
  await network.end();
}

run(main);
