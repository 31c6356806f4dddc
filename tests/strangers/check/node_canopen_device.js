'use strict';

// A device of node-canopen with an SDO server, on a bus behind a socketcand.
//
//     tests/strangers/with_node tests/strangers/check/node_canopen_device.js PORT NODE SHEET

const net = require('net');

const {Device, Eds} = require('canopen');

const port = Number(process.argv[2]);
const id = Number(process.argv[3]);

const eds = Eds.fromFile(process.argv[4]);
eds.addSdoServerParameter(0, 0x580 + id, 0x600 + id);
const device = new Device({id, eds});

// What a frame on the bus throws in the package costs the answer alone.
process.on('uncaughtException', () => {});

const socket = net.connect(port, '127.0.0.1');
socket.setNoDelay(true);

function begin() {
  device.on('message', (frame) => {
    const bytes = [...(frame.data ?? [])].map((byte) => ` ${byte.toString(16)}`).join('');
    socket.write(`< send ${frame.id.toString(16).padStart(3, '0')} ${frame.data?.length ?? 0}${bytes} >`);
  });
  device.start();
  console.log('ready');
}

let greetings = 0; // < ok > to `open`, and to `rawmode`
function take(message) {
  const [, word, ...rest] = message.split(' ');
  if (word === 'hi') return socket.write('< open can0 >');
  if (word === 'ok') return greetings++ === 0 ? socket.write('< rawmode >') : begin();
  if (word !== 'frame') return undefined;
  const data = Buffer.from(rest[2] ?? '', 'hex');
  return device.receive({id: parseInt(rest[0], 16), data, len: data.length});
}

let waiting = '';
socket.on('data', (bytes) => {
  const messages = (waiting + bytes.toString('latin1')).split('>');
  waiting = messages.pop();
  for (const message of messages) setImmediate(take, message.trim());
});
socket.on('close', () => process.exit(0));
