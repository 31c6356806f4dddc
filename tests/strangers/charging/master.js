'use strict';

// node-canopen beside a charger and a battery: NMT master, SDO client, consumer of heartbeats, emergencies and PDOs.

const {Device, Eds, DataType} = require('canopen');

const BATTERY = 10;
const CHARGER = 5;
const TIME_OUT_MS = 30000; // of one SDO transfer: the machine is emulated

class Master {
  constructor(bus) {
    const eds = new Eds();
    for (const node of [BATTERY, CHARGER]) {
      eds.addSdoClientParameter(node, 0x600 + node, 0x580 + node);
      eds.addHeartbeatConsumer(node, 60000);
      eds.addEmcyConsumer(0x80 + node);
    }
    this.readings = this.consumeBatteryPdos(eds);
    this.states = new Map();
    this.emergencies = [];

    this.device = new Device({id: 1, eds});
    this.device.on('message', ({id, data}) => bus.send(id, data));
    bus.on('frame', (frame) => {
      if (frame.id === null || frame.remote) return;
      setImmediate(() => this.device.receive({id: frame.id, data: frame.data, len: frame.data.length}));
    });
    this.device.nmt.on('heartbeat', ({deviceId, state}) => this.states.set(deviceId, state));
    this.device.emcy.on('emergency', ({cobId, em}) => this.emergencies.push({node: cobId - 0x80, code: em.code}));
    this.device.start();
    this.device.nmt.startNode();
  }

  // What the battery's three TPDOs carry, in the order of CiA 419, 6.2.3 to 6.2.7; raw values.
  consumeBatteryPdos(eds) {
    const entry = (index, dataType) => eds.addEntry(index, {parameterName: `raw ${index}`, dataType});
    const readings = {
      temperature: entry(0x6010, DataType.INTEGER16),
      status: entry(0x6000, DataType.UNSIGNED8),
      voltage: entry(0x6060, DataType.UNSIGNED32),
      current: entry(0x6070, DataType.UNSIGNED16),
      charge: entry(0x6081, DataType.UNSIGNED8),
    };
    const {temperature, status, voltage, current, charge} = readings;
    eds.addReceivePdo({cobId: 0x280 + BATTERY, dataObjects: [temperature, status, voltage]});
    eds.addReceivePdo({cobId: 0x380 + BATTERY, dataObjects: [current, charge]});
    return readings;
  }

  read(node, index, subIndex, dataType) {
    return this.device.sdo.upload({deviceId: node, index, subIndex, dataType, timeout: TIME_OUT_MS});
  }

  write(node, index, subIndex, data, dataType) {
    return this.device.sdo.download({deviceId: node, index, subIndex, data, dataType, timeout: TIME_OUT_MS});
  }

  // The abort code that reading ends with.
  async abortOf(transfer) {
    try {
      await transfer;
    } catch (error) {
      return error.code;
    }
    return undefined;
  }

  bothAre(state) {
    return this.states.get(BATTERY) === state && this.states.get(CHARGER) === state;
  }

  // node-canopen hears of a frame a moment after the bus.
  async hears(what, isHeard, seconds = 60) {
    const giveUp = Date.now() + seconds * 1000;
    while (!isHeard()) {
      if (Date.now() > giveUp) throw new Error(`within ${seconds} s node-canopen did not hear ${what}`);
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  }

  close() {
    this.device.stop();
  }
}

module.exports = {Master, BATTERY, CHARGER};
