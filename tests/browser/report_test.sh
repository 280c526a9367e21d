#!/usr/bin/env bash
# report_test.sh BIN: a report in a browser, as a reader has it: no errors, nothing from elsewhere, a slider that moves
# the picture, tables that sort. The browser is Debian's chromium, without a display; without one the test is skipped.
source "$(dirname "$0")/../pipeline/assert.sh"
bin=$1
skipped=77 # for ctest
command -v chromium >/dev/null || {
    echo "no chromium here: apt-get install chromium"
    exit $skipped
}
cp "$(dirname "$0")/../pipeline/tiny.toml" "$work"
cd "$work" || exit 1

for stage in geometry simulate postprocess; do
    "$bin/tidewater-$stage" tiny.toml --run run >stage.log 2>&1 || fail_case "$(cat stage.log)"
done
report=run/postprocess/report.html

# What a reader does, at the end of a copy of the page; what comes of it goes into #seen.
cat >reader.html <<'HTML'
<pre id="seen"></pre>
<script>
const seen = document.getElementById("seen"), say = (text) => { seen.textContent += text + "\n"; };
const shown = () => [...document.querySelectorAll("#slides img.shown")].map((image) => image.dataset.time).join();
window.addEventListener("load", () => {
  say("errors: " + window.problems.length + " " + window.problems.join());
  const from = performance.getEntriesByType("resource").map((entry) => entry.name);
  say("from elsewhere: " + from.filter((name) => !name.startsWith("data:")).length);
  say("broken pictures: " + [...document.images].filter((image) => !image.naturalWidth).length);
  say("without alternative text: " + [...document.images].filter((image) => !image.alt).length);
  say("first picture: " + shown());
  slider.value = slider.max;
  slider.dispatchEvent(new Event("input"));
  say("last picture: " + shown() + " and " + document.getElementById("time").textContent);
  play.click();
  say("playing: " + play.textContent + " from " + shown());
  play.click();
  const table = document.querySelector("table.sortable"), button = table.querySelector("th button");
  const first = () => [...table.tBodies[0].rows].map((row) => row.cells[0].textContent).join(" ");
  button.click();
  say("up: " + first());
  button.click();
  say("down: " + first());
  say("sorted: " + table.querySelector("th").getAttribute("aria-sort"));
  say("wider than the window: " + (document.documentElement.scrollWidth > window.innerWidth));
  say("end");
});
</script>
HTML
sed 's|<head>|<head><script>window.problems = []; window.addEventListener("error", (e) => problems.push(e.message));</script>|' \
    "$report" >read.html
cat reader.html >>read.html

browse() { # WIDTH FILE
    chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking \
        --disable-component-update --disable-sync --user-data-dir="$work/profile" --window-size="$1,900" \
        --dump-dom "file://$work/$2" 2>/dev/null | sed -n '/^<pre id="seen">/,$p'
}

case_named "the report is a page with the scene's title, its provenance and all its parts"
run grep -c "<h2>" "$report"
expect_same "$output" 6
run cat "$report"
expect_line "<h1>A tiny tank for the tests of the pipeline</h1>"
expect_line "<th scope=\"row\">scene_hash</th>"

for width in 1400 500; do
    case_named "in a window of $width pixels it shows, slides and sorts"
    run browse "$width" read.html
    expect_code 0
    expect_line "errors: 0 "
    expect_line "from elsewhere: 0"
    expect_line "broken pictures: 0"
    expect_line "without alternative text: 0"
    expect_line "first picture: 0.00"
    expect_line "last picture: 0.20 and t = 0.20 s"
    expect_line "playing: Pause from 0.00"
    expect_line "up: 0.8 1.2 -"
    expect_line "down: - 1.2 0.8"
    expect_line "sorted: descending"
    expect_line "wider than the window: false"
    expect_line "end"
done
