#!/bin/bash
#SBATCH --job-name=blossom
#SBATCH --array=1-8
#SBATCH --cpus-per-task=1
# Answers its part of the requests in $REQUESTS, as one task of a Slurm job array: REQUESTS=requests.jsonl sbatch examples/job-array.sh
# A part is written under another name until it is whole, so that a task that was stopped can be run again.
set -uo pipefail

part=$SLURM_ARRAY_TASK_ID of=${SLURM_PARTS:-$SLURM_ARRAY_TASK_MAX}
responses=$REQUESTS.$(printf %05d "$part").responses
split --number="l/$part/$of" "$REQUESTS" | "${BLOSSOM:-blossom}" batch --jobs "${SLURM_CPUS_PER_TASK:-1}" >"$responses.part"
status=$?
# 1 says that some requests were refused, whose responses say why.
((status <= 1)) && mv "$responses.part" "$responses"
