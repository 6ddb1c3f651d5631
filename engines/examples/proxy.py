#!/usr/bin/env python3
"""A worker that passes each question on to another, the program $PROXIED, and says in the file $PROXY_LOG what was asked.

A worker that answers in MessagePack is asked in MessagePack: read() decodes it. What a proxy changes in a question it may pass
on as JSON. It is for workers without runs_per_process.
"""
import io
import json
import os
import struct
import subprocess
import sys


def read(stream):
    """The next value of a MessagePack message; bytes are a list of numbers of eight bytes."""
    def number(size, signed=False):
        return int.from_bytes(stream.read(size), "big", signed=signed)
    kind = stream.read(1)[0]
    if kind < 0x80 or kind >= 0xE0:  # a whole number from -32 to 127
        return kind - 256 if kind >= 0xE0 else kind
    if kind in (0xC0, 0xC2, 0xC3):
        return {0xC0: None, 0xC2: False, 0xC3: True}[kind]
    if 0xC4 <= kind <= 0xC6:
        data = stream.read(number(2 ** (kind - 0xC4)))
        return list(struct.unpack(f"<{len(data) // 8}d", data))
    if kind in (0xCA, 0xCB):
        return struct.unpack(">f" if kind == 0xCA else ">d", stream.read(4 * (kind - 0xC9)))[0]
    if 0xCC <= kind <= 0xD3:
        return number(2 ** (kind % 4), kind >= 0xD0)
    if 0xA0 <= kind < 0xC0 or 0xD9 <= kind <= 0xDB:
        return stream.read(kind & 31 if kind < 0xC0 else number(2 ** (kind - 0xD9))).decode()
    count = kind & 15 if kind < 0xA0 else number(2 + 2 * (kind % 2))
    if 0x90 <= kind < 0xA0 or kind in (0xDC, 0xDD):
        return [read(stream) for _ in range(count)]
    return {read(stream): read(stream) for _ in range(count)}


def main():
    message = sys.stdin.buffer.read()
    question = json.loads(message) if message.lstrip()[:1] == b"{" else read(io.BytesIO(message))
    if "run" in question:
        with open(os.environ["PROXY_LOG"], "a") as log:
            asked = question["run"]
            print(json.dumps({name: asked[name] for name in ("solver", "dt", "steps", "friction")}), file=log)
    sys.exit(subprocess.run([os.environ["PROXIED"]], input=message, pass_fds=(3,)).returncode)


main()
