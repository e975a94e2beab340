#!/usr/bin/env python3
"""web_test.py PROGRAM BUILD_SCRIPT FOLDER: the page of examples/web in headless Chromium against the native program.

Builds the page in FOLDER. Drops files, draws, saves as a user does; what the page gives must be what the program gives.
Leaves screenshots in FOLDER. Needs emscripten, and what browser.py needs; without them it is skipped."""

import gzip
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

from browser import ActionChains, By, Page, browser_for, write_large_mesh
from helpers import EXAMPLES, partition_of, rows_of, run
from selenium.webdriver.common.keys import Keys


class LivePage(Page):
    def __init__(self, browser, file, program, folder, pictures):
        super().__init__(browser, file, folder)
        self.program, self.pictures = program, pictures
        self.script("""const hand = Object.assign(document.createElement("input"), {type: "file", id: "hand"});
                       hand.style.cssText = "position: fixed; right: 0; opacity: 0";
                       document.body.append(hand);""")

    def choose_method(self, method):
        self.script("""const select = document.getElementById("method"); select.value = arguments[0];
                       select.dispatchEvent(new Event("change"));""", method)
        self.idle()

    def idle(self):
        self.wait("!window.page.isBusy")

    def start_drop(self, name):
        """Drops a file of the folder on the page."""
        self.element("hand").send_keys(str(self.folder / name))
        self.script("""const hand = document.getElementById("hand"), dataTransfer = new DataTransfer();
                       dataTransfer.items.add(hand.files[0]);
                       hand.value = "";
                       document.body.dispatchEvent(new DragEvent("drop", {dataTransfer, bubbles: true, cancelable: true}));""")

    def drop(self, name):
        """The seconds from the drop to the picture."""
        start = time.time()
        self.start_drop(name)
        self.idle()
        return time.time() - start

    def problem(self):
        return self.element("problem").text

    def picture(self, name):
        time.sleep(0.4)
        self.save_picture(self.pictures / f"{name}.png")

    def native(self, name, *options):
        """The labels of the program, and its seconds."""
        start = time.time()
        run(self.folder, self.program, name, "-q", "-o", "native.seg", *options)
        return (self.folder / "native.seg").read_text().split(), time.time() - start

    def drag(self, places):
        """Draws a line from place to place of the canvas."""
        actions = self.move_to(places[0]).click_and_hold()
        for (x, y), (u, v) in zip(places, places[1:]):
            actions = actions.move_by_offset(u - x, v - y)
        actions.release().perform()
        self.idle()


def write_seeds(page, file):
    seeds = page.script("return Array.from(window.page.strokes.seeds())")
    file.write_text("".join(f"{face} {seed}\n" for face, seed in zip(seeds[::2], seeds[1::2])))
    return dict(zip(seeds[::2], seeds[1::2]))


def check_broken(page):
    """A sentence, and a page that goes on."""
    (page.folder / "broken.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n")
    (page.folder / "empty.stl").write_text("")
    (page.folder / "mesh.doc").write_text("text")
    (page.folder / "short.ply").write_bytes(b"ply\nformat binary_little_endian 1.0\nelement vertex 9\nproperty float x\n")
    for name, expected in (("broken.off", "broken.off:6:"), ("empty.stl", "is empty"), ("mesh.doc", ".off, .obj"), ("short.ply", "short.ply")):
        page.drop(name)
        assert expected in page.problem(), (name, page.problem())
        print("  " + page.problem())
    page.picture("broken")


def check_large(page):
    faces = write_large_mesh(page.folder / "a.off")
    page.script("document.getElementById('method').value = 'learned'")
    labels, native = page.native("a.off")
    seconds = page.drop("a.off")
    print(f"{faces} faces: first result after {seconds:.2f} s, program {native:.2f} s, ratio {seconds / native:.1f}")
    assert page.labels() == labels, "not the labels of the program"
    page.picture("dropped")
    slider = page.element("slider")
    slider.send_keys(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ARROW_RIGHT)
    assert page.labels() == page.native("a.off", "-k", str(page.count()))[0], "not the labels of the program"
    page.picture("slid")
    assert seconds < 12 * native, "more than five times the time of the program, with room for a busy machine"

    # Cancelling leaves what was there; the next file is opened as if nothing was.
    labels = page.labels()
    page.start_drop("a.off")
    page.wait("!document.getElementById('work').hidden")
    assert page.element("stage").text and page.element("progress").get_attribute("value")
    page.press("#cancel")
    page.idle()
    assert page.labels() == labels and page.element("work").get_attribute("hidden")


def check_formats(page):
    """The figure, 4,332 faces."""
    endings = ("obj", "ply", "glb", "stl")
    run(page.folder, page.program, "figure.off", "-q", *(word for ending in endings for word in ("-o", f"b.{ending}")))
    times = []
    (page.folder / "b.off.gz").write_bytes(gzip.compress((page.folder / "figure.off").read_bytes()))
    for name in ("figure.off", "b.off.gz", *(f"b.{ending}" for ending in endings)):
        times.append(page.drop(name))
        labels, native = page.native(name)
        print(f"{len(labels)} faces, {name}: first result after {times[-1]:.2f} s, program {native:.2f} s")
        assert page.labels() == labels, f"not the labels of the program: {name}"
    assert min(times) < 5, "more than a second, with room for a busy machine"


def check_methods(page):
    page.drop("figure.off")
    for method in ("visibility", "two-step", "learned"):
        k = page.count()
        page.choose_method(method)
        options = ["-k", str(k)] if method == "two-step" else []
        assert page.labels() == page.native("figure.off", "--method", method, *options)[0], method


def check_strokes(page):
    """Two strokes in one segment part it; the program does the same with these seeds."""
    page.drop("figure.off")
    before, k = page.labels(), page.count()
    segment, places = max(page.all_places().items(), key=lambda item: len(item[1]))
    top, bottom = min(places, key=lambda p: p[1]), max(places, key=lambda p: p[1])
    page.press("[data-tool=part]")
    page.drag([top, (top[0] + 6, top[1] + 4)])
    page.drag([bottom, (bottom[0] + 6, bottom[1] - 4)])
    seed_of_face = write_seeds(page, page.folder / "seeds.txt")
    assert set(seed_of_face.values()) == {0, 1}, seed_of_face
    after = page.labels()
    assert page.count() == k and partition_of(after) != partition_of(before), "the strokes have no effect"
    of_seeds = {seed: {after[face] for face, s in seed_of_face.items() if s == seed} for seed in (0, 1)}
    assert len(of_seeds[0]) == len(of_seeds[1]) == 1 and of_seeds[0] != of_seeds[1], of_seeds
    assert after == page.native("figure.off", "-k", str(k), "--seeds", "seeds.txt")[0], "not the labels of the program"
    page.picture("stroked")
    for _ in range(2):
        page.press("#undo")
        page.idle()
    assert page.labels() == page.native("figure.off", "-k", str(k))[0], "the strokes are not undone"


def check_keys(page):
    """What Tab reaches."""
    page.drop("figure.off")
    browser, reached = page.browser, []
    page.script("document.activeElement.blur()")
    for _ in range(30 + page.rows()):
        ActionChains(browser).send_keys(Keys.TAB).perform()
        reached.append(page.script("const a = document.activeElement; return a.id || a.dataset.tool || a.tagName"))
    for name in ("view", "open", "method", "count", "slider", "select", "part", "border", "LI", "save-labels", "save-picture",
                 "save-mesh", "format"):
        assert name in reached, (name, reached)
    page.script("document.getElementById('file').addEventListener('click', event => { event.preventDefault(); window.chosen = true; })")
    page.element("open").send_keys(Keys.ENTER)
    assert page.script("return window.chosen"), "Enter does not open a file"

    page.element("view").send_keys("5")
    assert page.script("return window.page.tool") == "border"


def check_line(page):
    """A line across the largest segment; the program does the same with the edges that it follows."""
    page.drop("figure.off")
    k, (segment, places) = page.count(), max(page.all_places().items(), key=lambda item: len(item[1]))
    middle = sum(y for _, y in places) / len(places)
    row = sorted(p for p in places if abs(p[1] - middle) < 12)
    page.press("[data-tool=border]")
    page.drag([row[0], row[-1]])
    page.idle()
    ends = page.script("return Array.from(window.page.strokes.constraints())")
    assert len(ends) > 4 and all(a != b for a, b in zip(ends[::2], ends[1::2])), ends
    (page.folder / "lines.txt").write_text("".join(f"{a} {b}\n" for a, b in zip(ends[::2], ends[1::2])))
    labels = page.native("figure.off", "-k", str(k), "--constraints", "lines.txt")[0]
    assert page.labels() == labels, "not the labels of the program"
    page.picture("line")
    page.press("#undo")
    page.idle()


def check_machine_part(page):
    page.drop("flange.off")
    page.choose_method("smooth-faces")
    assert page.labels() == page.native("flange.off", "--method", "smooth-faces", "-o", "native.csv")[0], "not those of the program"
    page.wait("window.page.nodes.every(node => window.page.shapes.has(node))")
    kinds = [item.text for item in page.browser.find_elements(By.CSS_SELECTOR, "#list .shape")]
    assert sorted(kinds) == sorted(row["primitive"] for row in rows_of(page.folder / "native.csv")), kinds
    colors = page.script("return Array.from(document.querySelectorAll('#list .swatch'), item => item.style.background)")
    assert len(set(zip(kinds, colors))) == len(set(colors)) == len(set(kinds)), (kinds, colors)
    page.picture("machine_part")


def check_saving(page):
    page.script("document.getElementById('method').value = 'learned'")
    page.drop("figure.off")
    page.press("[data-tool=select]")
    colors = page.script("return Array.from(document.querySelectorAll('#list .swatch'), item => item.style.background)")
    assert len(set(colors)) > 1, "segments of another method are colored by the kinds of surface"
    k, labels = page.count(), page.labels()
    for ending in (".ply", ".obj", ".off"):
        page.script("document.getElementById('format').value = arguments[0]", ending)
        page.press("#save-mesh")
        page.idle()
        page.native("figure.off", "-o", "native" + ending)
        native = (page.folder / f"native{ending}").read_bytes().removeprefix(b"mtllib native.mtl\n") # a page writes one file
        assert page.saved(f"figure_{k}{ending}") == native, ending
    assert page.labels() == labels


def test(program, script, folder, pictures):
    status = subprocess.run(["sh", script, pictures]).returncode
    if status != 0:
        sys.exit(status)
    file = pictures / "segment_mesh.html"
    size = file.stat().st_size
    print(f"{size / 1e6:.2f} MB")
    assert size <= 3e6
    for name in "figure.off", "flange.off":
        shutil.copy(EXAMPLES / "data" / name, folder)
    with browser_for(folder) as browser:
        page = LivePage(browser, file, program, folder, pictures)
        page.picture("empty")
        assert not page.browser.find_element(By.TAG_NAME, "aside").is_displayed()
        for check in (check_broken, check_formats, check_methods, check_strokes, check_line, check_keys, check_machine_part, check_saving, check_large):
            print(check.__name__, flush=True)
            check(page)
        page.check_looks()


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        test(sys.argv[1], sys.argv[2], pathlib.Path(name), pathlib.Path(sys.argv[3]))
