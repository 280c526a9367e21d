# Slides the slab of configs/overhang_N<N>.toml out over water of several depths, each until it breaks, and draws the
# lengths against eq. 1 of Wolper et al. (2021) and beam theory, as in their Fig. 3b:
#
#     make -f tools/overhang_sweep.mk N=5 [DEPTHS='0 0.2 0.4'] [SWEEP=runs/overhang_N5] [SET='--set a=1'] [BIN=build/bin]
#
# Each depth D/Hi is a run of its own, SWEEP/D<D/Hi>, through tools/pipeline.mk: what is up to date is not run again, and
# what was stopped goes on. The runs follow each other, each on all threads. Test: tests/pipeline/overhang_test.sh.

N ?= $(error say which scale: make -f tools/overhang_sweep.mk N=5, of 1, 3, 5, 10)
SCENE ?= configs/overhang_N$(N).toml
DEPTHS ?= 0 0.2 0.4 0.6 0.7 0.8 0.9 1.0 1.1 1.2
SWEEP ?= runs/overhang_N$(N)
BIN ?= build/bin
THREADS ?= 0
SET ?=

runs := $(addprefix $(SWEEP)/D,$(DEPTHS))

.PHONY: all $(runs)
.NOTPARALLEL:
all: $(SWEEP)/overhang.csv

$(SWEEP)/overhang.csv: $(runs)
	@$(BIN)/tidewater-overhang $(runs) --out $(SWEEP)

$(runs): $(SWEEP)/D%:
	@$(MAKE) --no-print-directory -f $(dir $(lastword $(MAKEFILE_LIST)))pipeline.mk SCENE=$(SCENE) RUN=$@ BIN=$(BIN) \
		THREADS=$(THREADS) SET="--set water.submergence=$* $(SET)"
