#!/usr/bin/env python3
"""Drops a file into a window of X11, as a file manager does (XDND 5, by hand: xdotool cannot).
  tests/window/drop.py WINDOW FILE      WINDOW: its number; exit status 1 when it does not take the file
"""
import ctypes
import pathlib
import sys
import time
from ctypes import POINTER, Structure, Union, byref, c_char_p, c_int, c_long, c_ulong, c_void_p

SELECTION_REQUEST, SELECTION_NOTIFY, CLIENT_MESSAGE = 30, 31, 33
PATIENCE = 20  # seconds


class Head(Structure):
    """What all events begin with."""
    _fields_ = [("type", c_int), ("serial", c_ulong), ("send_event", c_int), ("display", c_void_p), ("window", c_ulong)]


class Message(Structure):
    _fields_ = [*Head._fields_, ("kind", c_ulong), ("format", c_int), ("data", c_long * 5)]


class Request(Structure):
    _fields_ = [*Head._fields_, ("requestor", c_ulong), ("selection", c_ulong), ("target", c_ulong),
                ("property", c_ulong), ("time", c_ulong)]


class Notify(Structure):
    _fields_ = [*Head._fields_, ("selection", c_ulong), ("target", c_ulong), ("property", c_ulong), ("time", c_ulong)]


class Event(Union):
    _fields_ = [("type", c_int), ("message", Message), ("request", Request), ("notify", Notify), ("room", c_long * 24)]


x11 = ctypes.CDLL("libX11.so.6")
x11.XOpenDisplay.restype = c_void_p
x11.XInternAtom.restype = x11.XDefaultRootWindow.restype = x11.XCreateSimpleWindow.restype = c_ulong
x11.XInternAtom.argtypes = [c_void_p, c_char_p, c_int]
x11.XDefaultRootWindow.argtypes = x11.XPending.argtypes = x11.XFlush.argtypes = [c_void_p]
x11.XCreateSimpleWindow.argtypes = [c_void_p, c_ulong, c_int, c_int, *[ctypes.c_uint] * 3, c_ulong, c_ulong]
x11.XSetSelectionOwner.argtypes = [c_void_p, c_ulong, c_ulong, c_ulong]
x11.XSendEvent.argtypes = [c_void_p, c_ulong, c_int, c_long, POINTER(Event)]
x11.XChangeProperty.argtypes = [c_void_p, c_ulong, c_ulong, c_ulong, c_int, c_int, c_char_p, c_int]
x11.XNextEvent.argtypes = [c_void_p, POINTER(Event)]

target, uri = int(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve().as_uri().encode() + b"\r\n"
display = x11.XOpenDisplay(None)
if not display:
    sys.exit("drop: there is no screen")


def atom(name):
    return x11.XInternAtom(display, name, 0)


def send(name, *data):
    event = Event(message=Message(CLIENT_MESSAGE, 0, 1, None, target, atom(name), 32, (c_long * 5)(source, *data)))
    x11.XSendEvent(display, target, 0, 0, byref(event))


source = x11.XCreateSimpleWindow(display, x11.XDefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0)
x11.XSetSelectionOwner(display, atom(b"XdndSelection"), source, 0)
send(b"XdndEnter", 5 << 24, atom(b"text/uri-list"), 0, 0)
send(b"XdndPosition", 0, 0, 0, atom(b"XdndActionCopy"))
x11.XFlush(display)
end = time.monotonic() + PATIENCE
while time.monotonic() < end:
    if not x11.XPending(display):
        time.sleep(0.01)
        continue
    event = Event()
    x11.XNextEvent(display, byref(event))
    if event.type == CLIENT_MESSAGE and event.message.kind == atom(b"XdndStatus"):
        if not event.message.data[1] & 1:
            sys.exit("drop: the window wants no file")
        send(b"XdndDrop", 0, 0, 0, 0)
    elif event.type == SELECTION_REQUEST:
        asked = event.request
        x11.XChangeProperty(display, asked.requestor, asked.property, asked.target, 8, 0, uri, len(uri))
        answer = Event(notify=Notify(SELECTION_NOTIFY, 0, 1, None, asked.requestor, asked.selection, asked.target,
                                     asked.property, asked.time))
        x11.XSendEvent(display, asked.requestor, 0, 0, byref(answer))
    elif event.type == CLIENT_MESSAGE and event.message.kind == atom(b"XdndFinished"):
        sys.exit(0)
    x11.XFlush(display)
sys.exit("drop: the window did not take the file")
