'use strict';

// A program that runs beside the test: what it printed, and how it ends.
//
//     const battery = new Program(SPEAKERS, 'build/canvoy', 'device', 'battery', 'vcan0');
//     await battery.says(/pre-operational/);
//     await battery.end();

const assert = require('assert');
const {spawn} = require('child_process');

class Program {
  constructor(prefix, ...command) {
    this.command = command;
    this.out = '';
    this.errors = '';
    const [first, ...rest] = [...prefix, ...command];
    this.child = spawn(first, rest, {stdio: ['ignore', 'pipe', 'pipe']});
    this.child.stdout.on('data', (text) => (this.out += text));
    this.child.stderr.on('data', (text) => (this.errors += text));
    this.status = new Promise((resolve) => this.child.on('close', (code, signal) => resolve(code ?? signal)));
  }

  async says(pattern, {seconds = 90, on = 'out'} = {}) {
    const giveUp = Date.now() + seconds * 1000;
    while (!pattern.test(this[on])) {
      assert.ok(this.runs(), `${this.command.join(' ')} has ended: ${this.errors}`);
      assert.ok(Date.now() < giveUp, `${this.command.join(' ')} did not say ${pattern}, but:\n${this[on]}`);
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
  }

  runs() {
    return this.child.exitCode === null && this.child.signalCode === null;
  }

  // Asks it to end: it does so without an error, and has never complained, or of this alone.
  async end(complaint = '') {
    this.child.kill('SIGTERM');
    assert.strictEqual(await this.status, 0, `${this.command.join(' ')}: ${this.errors}`);
    if (complaint instanceof RegExp) assert.match(this.errors, complaint);
    else assert.strictEqual(this.errors, complaint);
  }
}

module.exports = {Program};
