# Runs the three icebergs of the laboratory, configs/lab_<case>.toml, and draws their first waves in one picture, as in
# Fig. 2b of Wolper et al. (2021):
#
#     make -f tools/lab_tsunamis.mk [CASES='gravity_fall capsize'] [OUT=runs/lab] [SET='--set a=1'] [BIN=build/bin]
#
# Each case is a run of its own, OUT/<case>, through tools/pipeline.mk: what is up to date is not run again, and what was
# stopped goes on. OUT/lab.csv and lab.svg, also as PNG where rsvg-convert is installed, come from tidewater-lab.
# Test: tests/pipeline/lab_test.sh.

CASES ?= gravity_fall buoyant_fall capsize
SCENES ?= configs
OUT ?= runs/lab
BIN ?= build/bin
THREADS ?= 0
SET ?=

label_gravity_fall := GF
label_buoyant_fall := BF
label_capsize := CS

runs := $(addprefix $(OUT)/,$(CASES))

.PHONY: all $(runs)
.NOTPARALLEL:
all: $(runs)
	@$(BIN)/tidewater-lab $(foreach case,$(CASES),$(label_$(case))=$(OUT)/$(case)) --out $(OUT)
	@if command -v rsvg-convert >/dev/null; then rsvg-convert $(OUT)/lab.svg -o $(OUT)/lab.png; fi

$(runs): $(OUT)/%:
	@$(MAKE) --no-print-directory -f $(dir $(lastword $(MAKEFILE_LIST)))pipeline.mk SCENE=$(SCENES)/lab_$*.toml RUN=$@ \
		BIN=$(BIN) THREADS=$(THREADS) SET="$(SET)"
