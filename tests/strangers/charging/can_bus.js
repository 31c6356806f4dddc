'use strict';

// A CAN interface for node, which has no CAN sockets: it hears through candump, and speaks through canplayer, also as a
// stranger of its own.
//
//     const bus = new CanBus('vcan0', 'candump.log');
//     bus.on('frame', ({time, id, extended, remote, data, text}) => ...);
//     await bus.until('the boot-up of node 10', (frame) => frame.text === '70A#00');

const {spawn} = require('child_process');
const {EventEmitter} = require('events');
const fs = require('fs');
const readline = require('readline');

const LINE = /^\((\d+\.\d{6})\) \S+ (([0-9A-F]{3}|[0-9A-F]{8})#(R?)([0-9A-F]*))/;

// All that speak are on one processor and all that listen on the other: a frame is queued for delivery on the
// processor of its sender, and with one queue there is one order of frames for all who listen.
const SPEAKERS = ['taskset', '-c', '0'];
const LISTENERS = ['taskset', '-c', '1'];

function start(prefix, command, stdio) {
  const [first, ...rest] = [...prefix, ...command];
  return spawn(first, rest, {stdio});
}

function parseLine(line) {
  const found = LINE.exec(line);
  if (!found) return null;
  const [, time, text, id, remote, bytes] = found;
  return {
    time: Number(time),
    text,
    id: id.length === 3 ? parseInt(id, 16) : null, // of 11 bits
    remote: remote === 'R',
    data: Buffer.from(remote ? '' : bytes, 'hex'),
  };
}

class CanBus extends EventEmitter {
  constructor(name, logPath) {
    super();
    this.setMaxListeners(50);
    this.name = name;
    this.heard = [];
    this.log = fs.openSync(logPath, 'w');
    this.candump = start(LISTENERS, ['candump', '-L', `${name},0:0,#FFFFFFFF`], ['ignore', 'pipe', 'inherit']);
    readline.createInterface({input: this.candump.stdout}).on('line', (line) => this.hear(line));
    [this.player, this.thrower] = [0, 1].map(() => start(SPEAKERS, ['canplayer', '-t'], ['pipe', 'inherit', 'inherit']));
  }

  hear(line) {
    fs.writeSync(this.log, line + '\n');
    const frame = parseLine(line);
    if (!frame) return;
    this.heard.push(frame);
    this.emit('frame', frame);
  }

  // The identifier has 11 bits, as all of node-canopen.
  send(id, data) {
    const hex = (number, digits) => number.toString(16).toUpperCase().padStart(digits, '0');
    this.play(this.player, `${hex(id, 3)}#${data.toString('hex').toUpperCase()}`);
  }

  // By another program; the frames of one go out in their order.
  throwIn(text) {
    this.play(this.thrower, text);
  }

  play(program, text) {
    program.stdin.write(`(0.000000) ${this.name} ${text}\n`);
  }

  // Resolves with the first frame from now on of which `wanted` holds; rejects after a time that only a dead partner
  // needs.
  until(what, wanted, seconds = 90) {
    return new Promise((resolve, reject) => {
      const stop = () => {
        this.off('frame', look);
        clearTimeout(timer);
      };
      const look = (frame) => {
        if (!wanted(frame)) return;
        stop();
        resolve(frame);
      };
      const timer = setTimeout(() => {
        stop();
        reject(new Error(`within ${seconds} s nobody heard ${what}`));
      }, seconds * 1000);
      this.on('frame', look);
    });
  }

  // Throws a frame in, and resolves when it was heard.
  async mark(text) {
    const heard = this.until(text, (frame) => frame.text === text);
    this.throwIn(text);
    await heard;
  }

  close() {
    this.player.stdin.end();
    this.thrower.stdin.end();
    this.candump.kill('SIGINT');
  }
}

module.exports = {CanBus, SPEAKERS, LISTENERS};
