#!/bin/sh
# with_display.sh COMMAND...: runs the command in a virtual display. Without -noreset the server starts anew whenever its
# last client leaves, and refuses whoever comes meanwhile: a program that closes one context and opens the next.
exec xvfb-run -a -s "-screen 0 1280x800x24 -noreset" "$@"
