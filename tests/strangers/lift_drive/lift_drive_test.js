'use strict';

// A car drive unit of CiA 417-4 with node-canopen as its controller: through the state machine of CiA 402 by control
// PDOs, two metres up in profile position mode, a quick stop on the way down, and what the drive refuses.
//
//     node tests/strangers/lift_drive/lift_drive_test.js PEER
//
// PEER is the program of peer.cpp.

const assert = require('assert');
const {Eds, DataType} = require('canopen');
const {Stranger} = require('../stranger');
const {Wire, run} = require('../wire');

const CONTROLLER = 1;
const DRIVE = 2;

class Controller extends Stranger {
  constructor(wire) {
    const eds = new Eds();
    super(wire, CONTROLLER, DRIVE, eds);
    const entry = (index, parameterName, dataType) => eds.addEntry(index, {parameterName, dataType});
    this.control = entry(0x6400, 'controlword', DataType.UNSIGNED16);
    this.target = entry(0x6420, 'target position', DataType.INTEGER32);
    this.status = entry(0x6401, 'statusword', DataType.UNSIGNED16);
    this.effort = entry(0x6406, 'control effort', DataType.INTEGER32);
    eds.addTransmitPdo({cobId: 0x180, transmissionType: 254, dataObjects: [this.control, this.target]});
    eds.addReceivePdo({cobId: 0x181, dataObjects: [this.status, this.effort]});
  }

  async command(word, mask, bits, what) {
    this.control.value = word;
    await this.shows(mask, bits, what);
  }
  async shows(mask, bits, what) {
    await this.wire.until(what, () => (this.status.value & mask) === bits);
  }
  async enable() {
    await this.command(0x0006, 0x6F, 0x21, 'ready to switch on');
    await this.command(0x0007, 0x6F, 0x23, 'switched on');
    await this.command(0x000F, 0x6F, 0x27, 'operation enabled');
  }
  // Target first, then the edge of bit 4, which the drive acknowledges by bit 12.
  async travel(position) {
    this.target.value = position;
    await this.command(0x001F, 0x1000, 0x1000, 'the acknowledgement');
    await this.command(0x000F, 0x1000, 0x0000, 'its end');
  }
  async car() {
    const before = this.wire.heard.length;
    const isCar = (line) => line.startsWith('car ');
    this.wire.tell('where');
    await this.wire.until('the car', () => this.wire.heard.slice(before).some(isCar));
    const words = this.wire.heard.slice(before).find(isCar).split(' ');
    return {position: Number(words[1]), brake: words[2]};
  }
  // Within the position window of the drive, behind its brake.
  async standsAt(position) {
    const car = await this.car();
    assert.ok(Math.abs(car.position - position) <= 2, `the car is at ${car.position}, not at ${position}`);
    assert.strictEqual(car.brake, 'closed');
  }
}

async function main() {
  const wire = new Wire(process.argv[2]);
  const controller = new Controller(wire);
  await controller.open();
  controller.start();
  assert.strictEqual(await controller.read(0x1000, 0, DataType.UNSIGNED32), 0x090001A1);
  assert.strictEqual(await controller.read(0x6404, 0, DataType.INTEGER8), 1, 'profile position mode');
  assert.strictEqual(await controller.refusal(0x6403, 0, 8, DataType.INTEGER8), 0x06090030);
  assert.strictEqual(await controller.refusal(0x6423, 0, 1601, DataType.UNSIGNED32), 0x06090031);
  await controller.write(0x6422, 2, 10000, DataType.INTEGER32);
  assert.strictEqual(await controller.refusal(0x6420, 0, 10001, DataType.INTEGER32), 0x06090031);

  await controller.enable();
  assert.strictEqual(await controller.refusal(0x6423, 0, 1000, DataType.UNSIGNED32), 0x08000022);
  await controller.travel(2000);
  await controller.wire.until('it moves', () => controller.effort.value > 500);
  assert.strictEqual((await controller.car()).brake, 'open');
  await controller.shows(0x0400, 0x0400, 'the target');
  await controller.standsAt(2000);

  await controller.travel(0);
  await controller.wire.until('it goes down', () => controller.effort.value < -500);
  await controller.command(0x0002, 0x6F, 0x07, 'quick stop active');
  await controller.shows(0x4F, 0x40, 'switch on disabled');
  const stopped = await controller.car();
  assert.ok(stopped.position > 0 && stopped.position < 2000, `on its way, at ${stopped.position}`);
  assert.strictEqual(stopped.brake, 'closed');

  await controller.enable();
  await controller.travel(0);
  await controller.shows(0x0400, 0x0400, 'the target');
  await controller.standsAt(0);
  await wire.end();
}

run(main);
