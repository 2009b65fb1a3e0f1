"""One HTML file of the page's parts: pack.py SHELL PROGRAM.js PROGRAM.wasm FILE PAGE.js...

The machine code goes in compressed: a browser takes it apart in some hundredths of a second, and a page of a third of the size is
there sooner."""
import base64
import gzip
import pathlib
import sys

shell, program, code, file, *scripts = map(pathlib.Path, sys.argv[1:])
text = shell.read_text()
parts = {
    "{{{ PROGRAM }}}": program.read_text().replace("</script", "<\\/script"),
    "{{{ PAGE }}}": "".join(script.read_text() for script in scripts),
    "{{{ CODE }}}": base64.b64encode(gzip.compress(code.read_bytes(), 9, mtime=0)).decode(),
}
for mark, part in parts.items():
    if text.count(mark) != 1:
        sys.exit(f"{shell}: {mark} is there {text.count(mark)} times, not once")
    text = text.replace(mark, part)
file.write_text(text)
