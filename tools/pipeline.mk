# Runs the stages of a scene, each one only if its part of the scene, its input or its executable has changed:
#
#     make -f tools/pipeline.mk SCENE=configs/quickstart.toml [RUN=runs/quickstart] [SET='--set a=1 --set b=2']
#                               [BIN=build/bin] [THREADS=n] [FROM=start|CHECKPOINT] [MOVIE=--movie]
#
# RUN/parts/<stage>.toml holds the keys that the stage reads and is replaced only when their text changes.
# A stage's target is the file that it writes last, so what an interrupted stage leaves does not count as done.
# SIGTERM to make, or Ctrl-C, lets simulate write a checkpoint, from which the same command goes on; FROM is its --from.
# Test: tests/pipeline/pipeline_test.sh

SCENE ?= $(error say which scene: make -f tools/pipeline.mk SCENE=configs/quickstart.toml)
RUN ?= runs/$(basename $(notdir $(SCENE)))
BIN ?= build/bin
THREADS ?= 0
SET ?=
FROM ?=
MOVIE ?=

geometry := $(RUN)/geometry/geometry.vdb
simulate := $(RUN)/simulate/ledger.csv
postprocess := $(RUN)/postprocess/report.html

program = $(BIN)/tidewater-$(1)
part = $(RUN)/parts/$(1).toml

# tools/run ends with the exit code of the stage that failed, which make does not tell. The shell passes signals on and
# waits: make ends its shell but not what runs in it. A trap ends the wait early, so it waits while the stage is there.
define run_stage
@$(program) $(SCENE) $(SET) --run $(RUN) --threads $(THREADS) $(2) & stage=$$!; \
	trap 'kill -TERM $$stage 2>/dev/null' INT TERM; \
	while wait $$stage; code=$$?; kill -0 $$stage 2>/dev/null; do :; done; \
	[ $$code = 0 ] || { echo $$code >$(RUN)/parts/exit_code; exit $$code; }
endef

.PHONY: all force
.DELETE_ON_ERROR:
all: $(postprocess)

$(geometry): $(call part,geometry) $(call program,geometry)
	$(call run_stage,geometry)

$(simulate): $(geometry) $(call part,simulate) $(call program,simulate)
	$(call run_stage,simulate,$(if $(FROM),--from $(FROM)))

# A movie that is wanted and not there is made; the stage skips what is up to date.
$(postprocess): $(simulate) $(call part,postprocess) $(call program,postprocess) \
		$(if $(MOVIE),$(if $(wildcard $(RUN)/postprocess/frames.mp4),,force))
	$(call run_stage,postprocess,$(MOVIE))

$(RUN)/parts/%.toml: force
	@part=$$($(call program,$*) $(SCENE) $(SET) --print-part $*) && mkdir -p $(@D) && \
	{ [ "$$part" = "$$(cat $@ 2>/dev/null)" ] || { printf '%s\n' "$$part" >$@.new && mv $@.new $@; }; }
