#!/usr/bin/env python3
"""A joystick that a test moves: an input device of the kernel's uinput, by lines of standard input.

    stick.py

It says `device /dev/input/eventN` when it is plugged in, and `led CODE VALUE` when somebody switches one of its lights.

    abs CODE VALUE      what happens until `report` happens at one time
    key CODE VALUE
    report
    unplug
    plug
"""

import fcntl
import glob
import os
import selectors
import struct
import sys
import time

EVENT = struct.Struct("llHHi")
EV_SYN, EV_KEY, EV_ABS, EV_LED = 0, 1, 3, 0x11
AXES = (0, 1, 5)  # ABS_X, ABS_Y, ABS_RZ
LEAST, MOST = 0, 1023
BUTTONS = (0x120, 0x121)  # BTN_TRIGGER, BTN_THUMB
LEDS = (7,)  # LED_MUTE

# linux/uinput.h
UI_DEV_CREATE, UI_DEV_DESTROY = 0x5501, 0x5502
UI_DEV_SETUP, UI_ABS_SETUP = 0x405C5503, 0x401C5504
UI_SET_EVBIT, UI_SET_KEYBIT, UI_SET_ABSBIT, UI_SET_LEDBIT = 0x40045564, 0x40045565, 0x40045567, 0x40045569
UI_GET_SYSNAME_64 = 0x8040552C


class Stick:
    def __init__(self):
        self.file = os.open("/dev/uinput", os.O_RDWR | os.O_NONBLOCK)
        for kind, set_bit, codes in ((EV_KEY, UI_SET_KEYBIT, BUTTONS), (EV_ABS, UI_SET_ABSBIT, AXES), (EV_LED, UI_SET_LEDBIT, LEDS)):
            fcntl.ioctl(self.file, UI_SET_EVBIT, kind)
            for code in codes:
                fcntl.ioctl(self.file, set_bit, code)
        for code in AXES:
            middle = (LEAST + MOST + 1) // 2
            fcntl.ioctl(self.file, UI_ABS_SETUP, struct.pack("Hxxiiiiii", code, middle, LEAST, MOST, 0, 0, 0))
        fcntl.ioctl(self.file, UI_DEV_SETUP, struct.pack("HHHH80sI", 3, 0x1234, 0x5678, 1, b"stick of a test", 0))
        fcntl.ioctl(self.file, UI_DEV_CREATE)
        name = fcntl.ioctl(self.file, UI_GET_SYSNAME_64, bytes(64)).split(b"\0")[0].decode()
        while not (found := glob.glob(f"/sys/devices/virtual/input/{name}/event*")):
            time.sleep(0.01)
        self.path = "/dev/input/" + os.path.basename(found[0])
        while not os.path.exists(self.path):
            time.sleep(0.01)

    def send(self, kind, code, value):
        os.write(self.file, EVENT.pack(0, 0, kind, code, value))

    def hear(self):
        data = os.read(self.file, EVENT.size)
        _, _, kind, code, value = EVENT.unpack(data)
        if kind == EV_LED:
            print(f"led {code} {value}", flush=True)

    def close(self):
        fcntl.ioctl(self.file, UI_DEV_DESTROY)
        os.close(self.file)


def main():
    stick = None
    listening = selectors.DefaultSelector()
    listening.register(0, selectors.EVENT_READ)
    rest = b""

    def plug():
        nonlocal stick
        stick = Stick()
        listening.register(stick.file, selectors.EVENT_READ)
        print("device", stick.path, flush=True)

    def obey(words):
        if words[0] == "plug":
            plug()
        elif words[0] == "unplug":
            listening.unregister(stick.file)
            stick.close()
        elif words[0] == "report":
            stick.send(EV_SYN, 0, 0)
        else:
            stick.send({"abs": EV_ABS, "key": EV_KEY}[words[0]], int(words[1]), int(words[2]))

    plug()
    while True:
        for key, _ in listening.select():
            if key.fd != 0:
                stick.hear()
                continue
            data = os.read(0, 4096)
            if not data:
                return
            *lines, rest = (rest + data).split(b"\n")
            for line in lines:
                obey(line.decode().split())


sys.exit(main())
