#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Usage: bash fuzz.sh <name>     in the folder of the fuzzers
#
# Give a fuzzer random inputs: 8,000 of them, the same ones each time; with GODRAYS_LONG for 10 min, others
# each time, which go on from what was found before, in corpus/<name>. GODRAYS_SEED takes those of that seed.
# An input with a fault is left in fault-<name>-*.

set -euo pipefail
name=$1
limit=-runs=8000
seed=${GODRAYS_SEED:-1}
if [ -n "${GODRAYS_LONG:-}" ]; then
  limit=-max_total_time=600
  seed=${GODRAYS_SEED:-0} # any
else
  rm -rf "corpus/$name"
fi
mkdir -p "corpus/$name"
exec "./Fuzz$name" "$limit" -seed="$seed" -max_len=4096 -timeout=60 -close_fd_mask=1 \
  -artifact_prefix="fault-$name-" "corpus/$name" "$(dirname "${BASH_SOURCE[0]}")/Seeds/$name"
