'use strict';

// A device of node-canopen that commands a node of ours over a wire: NMT, and objects by SDO.
//
//     const master = new Stranger(wire, 1, 5, eds);
//     await master.open();
//     master.start();
//     await master.write(0x1017, 0, 500, DataType.UNSIGNED16);

const {Device} = require('canopen');

const TIME_OUT_MS = 30000;

class Stranger {
  constructor(wire, id, other, eds) {
    this.wire = wire;
    this.other = other;
    eds.addSdoClientParameter(other, 0x600 + other, 0x580 + other);
    this.device = new Device({id, eds});
    wire.connect(this.device);
  }

  // It listens, and ours has booted.
  async open() {
    this.device.start();
    await this.wire.hears(`${(0x700 + this.other).toString(16)}#00`);
  }
  start() {
    this.device.nmt.startNode(); // itself
    this.device.nmt.startNode(this.other);
  }
  read(index, subIndex, dataType) {
    return this.device.sdo.upload({deviceId: this.other, index, subIndex, dataType, timeout: TIME_OUT_MS});
  }
  write(index, subIndex, data, dataType, more = {}) {
    const object = {deviceId: this.other, index, subIndex, data, dataType};
    return this.device.sdo.download({...object, timeout: TIME_OUT_MS, ...more});
  }
  // The abort code; 0 where it is written.
  refusal(index, subIndex, data, dataType) {
    return this.write(index, subIndex, data, dataType).then(() => 0, (error) => error.code);
  }
}

module.exports = {Stranger};
