#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Usage: bash fuzz.sh <name>     in the folder of the fuzzers
#
# Give a fuzzer random inputs: for 10 s, the same ones each time; with GODRAYS_LONG for 10 min, others each
# time. GODRAYS_SEED takes those of that seed. What it finds goes on from what it found before, in
# corpus/<name>; an input with a fault is left in fault-<name>-*.

set -euo pipefail
name=$1
seconds=10
seed=${GODRAYS_SEED:-1}
if [ -n "${GODRAYS_LONG:-}" ]; then
  seconds=600
  seed=${GODRAYS_SEED:-0} # any
fi
mkdir -p "corpus/$name"
exec "./Fuzz$name" -max_total_time="$seconds" -seed="$seed" -max_len=4096 -timeout=60 -close_fd_mask=1 \
  -artifact_prefix="fault-$name-" "corpus/$name" "$(dirname "${BASH_SOURCE[0]}")/Seeds/$name"
