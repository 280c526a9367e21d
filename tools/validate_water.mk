# Runs the water scenes of configs/validation and compares them with their references:
#
#     make -f tools/validate_water.mk [SCENES='rest dam_break'] [LENGTHS='12 6'] [OUT=runs/validation] [SET='--set a=1'] [BIN=build/bin]
#
# Each scene is a run of its own, OUT/<scene>, through tools/pipeline.mk; dispersion is one per wave.length,
# OUT/dispersion_<length>, of six periods each. What is up to date is not run again. OUT/validation.csv and a chart per
# scene, also as PNG where rsvg-convert is installed, come from tidewater-validate-water.
# Test: tests/pipeline/validate_water_test.sh

SCENES ?= rest standing_wave standing_wave_long dispersion solitary_wave dam_break dam_break_rough dam_break_rough_small \
	dam_break_pressure
LENGTHS ?= 12 6 4 3 2 1.5 1.2 1
OUT ?= runs/validation
BIN ?= build/bin
THREADS ?= 0
SET ?=

tools := $(dir $(lastword $(MAKEFILE_LIST)))
project := $(tools)..
single := $(addprefix $(OUT)/,$(filter-out dispersion,$(SCENES)))
sweep := $(if $(filter dispersion,$(SCENES)),$(addprefix $(OUT)/dispersion_,$(LENGTHS)))

# Six periods of linear theory in the scene's 1 m of water, to a hundredth of a second.
six_periods = $(shell awk 'BEGIN { k = 8 * atan2(1, 1) / $(1); e = exp(2 * k); printf "%.2f", 48 * atan2(1, 1) / sqrt(9.81 * k * (e - 1) / (e + 1)) }')

pipeline = $(MAKE) --no-print-directory -f $(tools)pipeline.mk RUN=$@ BIN=$(BIN) THREADS=$(THREADS)

.PHONY: all $(single) $(sweep)
.NOTPARALLEL:
all: $(single) $(sweep)
	@$(BIN)/tidewater-validate-water $^ --out $(OUT) --data $(project)/tests/validation/data
	@if command -v rsvg-convert >/dev/null; then for svg in $(OUT)/*.svg; do rsvg-convert $$svg -o $${svg%.svg}.png; done; fi

$(single): $(OUT)/%:
	@$(pipeline) SCENE=$(project)/configs/validation/$*.toml SET="$(SET)"

$(sweep): $(OUT)/dispersion_%:
	@$(pipeline) SCENE=$(project)/configs/validation/dispersion.toml \
		SET="--set wave.length=$* --set simulate.end_time=$(call six_periods,$*) --set simulate.snapshot_interval=$(call six_periods,$*) $(SET)"
