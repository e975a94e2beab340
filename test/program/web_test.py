#!/usr/bin/env python3
"""web_test.py PROGRAM BUILD_SCRIPT FOLDER: the page of examples/web in headless Chromium against the native program.

Builds the page in FOLDER. Drops files, draws, saves as a user does; what the page gives must be what the program gives.
Leaves screenshots in FOLDER. Needs emscripten, and what page_test.py needs; without them it is skipped."""

import json
import math
import pathlib
import subprocess
import sys
import tempfile
import time

from page_test import (ActionChains, By, Keys, Page, beside_itself, check_looks, make_mesh, partition_of, read_off, start_browser,
                       write_off)


class LivePage(Page):
    def __init__(self, browser, file, program, folder, pictures):
        super().__init__(browser, file)
        self.program, self.folder, self.pictures = program, folder, pictures
        browser.execute_script("""const hand = Object.assign(document.createElement("input"), {type: "file", id: "hand"});
                                  hand.style.cssText = "position: fixed; right: 0; opacity: 0";
                                  document.body.append(hand);""")

    def script(self, text, *values):
        return self.browser.execute_script(text, *values)

    def wait(self, condition, seconds=120):
        end = time.time() + seconds
        while not self.script("return " + condition):
            assert time.time() < end, f"not in {seconds} s: {condition}"
            time.sleep(0.005)

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
        self.browser.save_screenshot(str(self.pictures / f"{name}.png"))

    def native(self, name, *options):
        """The labels of the program, and its seconds."""
        start = time.time()
        subprocess.run([self.program, name, "-q", "-o", "native.seg", *options], cwd=self.folder, check=True,
                       stdout=subprocess.DEVNULL)
        return (self.folder / "native.seg").read_text().split(), time.time() - start

    def drag(self, places, beside=None):
        """Draws a line from place to place of the canvas."""
        actions = self.move_to(places[0]).click_and_hold()
        for (x, y), (u, v) in zip(places, places[1:]):
            actions = actions.move_by_offset(u - x, v - y)
        actions.release().perform()
        self.idle()

    def downloaded(self, name):
        file = self.folder / name
        for _ in range(100):
            if file.exists():
                return file.read_bytes()
            time.sleep(0.1)
        raise AssertionError(f"{name} is not saved: {sorted(f.name for f in self.folder.iterdir())}")


def write_stl(file, points, faces):
    lines = ["solid a"]
    for face in faces:
        corners = "".join(" vertex {!r} {!r} {!r}".format(*points[i]) for i in face)
        lines.append(f"facet normal 0 0 0 outer loop{corners} endloop endfacet")
    file.write_text("\n".join(lines + ["endsolid"]) + "\n")


def write_bolt(file):
    """A cylinder on a hexagonal prism."""
    rings = [(6, 2.0, 0.0), (6, 2.0, 1.0), (48, 1.0, 1.0), (48, 1.0, 5.0)]
    points, starts, faces = [], [], []
    for n, radius, z in rings:
        starts.append(len(points))
        points += [(radius * math.cos(2 * math.pi * i / n), radius * math.sin(2 * math.pi * i / n), z) for i in range(n)]

    def ring(k):
        return [starts[k] + i for i in range(rings[k][0])]

    for a, b in ((0, 1), (2, 3)):
        n = rings[a][0]
        faces += [(ring(a)[i], ring(a)[(i + 1) % n], ring(b)[(i + 1) % n], ring(b)[i]) for i in range(n)]
    faces += [tuple(reversed(ring(0))), tuple(ring(3))]
    for i in range(6):  # the ring between hexagon and circle
        inner = [starts[2] + (8 * i + j) % 48 for j in range(9)]
        faces.append((starts[1] + i, starts[1] + (i + 1) % 6, *reversed(inner)))
    lines = [f"OFF\n{len(points)} {len(faces)} 0"] + [f"{x!r} {y!r} {z!r}" for x, y, z in points]
    file.write_text("\n".join(lines + [" ".join(map(str, (len(face), *face))) for face in faces]) + "\n")


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
    faces = make_mesh(page.program, page.folder)
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
    """Files of two figures side by side, 13,880 faces."""
    points, faces = beside_itself(*read_off(page.folder / "figure.off"))
    write_off(page.folder / "b.off", points, faces)
    write_stl(page.folder / "b.stl", points, faces)
    for ending in ("obj", "ply", "glb"):
        subprocess.run([page.program, "b.off", "-q", "-o", f"b.{ending}"], cwd=page.folder, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["gzip", "-k", "b.off"], cwd=page.folder, check=True)
    times = []
    for ending in ("off", "off.gz", "obj", "ply", "glb", "stl"):
        seconds = page.drop(f"b.{ending}")
        times.append(seconds)
        labels, native = page.native(f"b.{ending}")
        print(f"{len(faces)} faces, .{ending}: first result after {seconds:.2f} s, program {native:.2f} s")
        assert page.labels() == labels, f"not the labels of the program: .{ending}"
    assert min(times) < 5, "more than a second, with room for a busy machine"


def check_methods(page):
    page.drop("figure.off")
    for method in ("visibility", "two-step", "learned"):
        k = page.count()
        page.script("""const select = document.getElementById("method"); select.value = arguments[0];
                       select.dispatchEvent(new Event("change"));""", method)
        page.idle()
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
    """Everything without a mouse: what Tab reaches; a line round the body drawn by turning it below the pen."""
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

    view, k = page.element("view"), page.count()
    view.send_keys("5")
    assert page.script("return window.page.tool") == "border"
    view.send_keys(Keys.SPACE)
    page.picture("pen")
    view.send_keys(*[Keys.ARROW_RIGHT] * 72)
    view.send_keys(Keys.SPACE)
    page.idle()
    ends = page.script("return Array.from(window.page.strokes.constraints())")
    assert len(ends) > 20, ends
    (page.folder / "lines.txt").write_text("".join(f"{a} {b}\n" for a, b in zip(ends[::2], ends[1::2])))
    labels = page.labels()
    assert labels == page.native("figure.off", "-k", str(k), "--constraints", "lines.txt")[0], "not the labels of the program"
    _, faces = read_off(page.folder / "figure.off")
    faces_of_edge = {}
    for f, face in enumerate(faces):
        for i in range(3):
            faces_of_edge.setdefault(frozenset((face[i], face[i - 1])), []).append(f)
    apart = [len({labels[f] for f in faces_of_edge[frozenset(edge)]}) == 2 for edge in zip(ends[::2], ends[1::2])]
    assert sum(apart) > 0.9 * len(apart), f"{sum(apart)} of {len(apart)} edges of the line are borders"
    page.picture("line")
    page.press("#undo")
    page.idle()


def check_machine_part(page):
    write_bolt(page.folder / "bolt.off")
    page.drop("bolt.off")
    page.script("""const select = document.getElementById("method"); select.value = "smooth-faces";
                   select.dispatchEvent(new Event("change"));""")
    page.idle()
    labels = page.native("bolt.off", "--method", "smooth-faces")[0]
    assert page.labels() == labels, "not the labels of the program"
    page.wait("window.page.nodes.every(node => window.page.shapes.has(node))")
    kinds = [item.text for item in page.browser.find_elements(By.CSS_SELECTOR, "#list .shape")]
    assert kinds.count("cylinder") == 1 and kinds.count("plane") == len(set(labels)) - 1 == 9, kinds
    colors = page.script("return Array.from(document.querySelectorAll('#list .swatch'), item => item.style.background)")
    assert len(set(zip(kinds, colors))) == len(set(colors)) == 2, colors
    page.picture("machine_part")


def check_saving(page):
    page.script("document.getElementById('method').value = 'learned'")
    page.drop("figure.off")
    page.press("[data-tool=select]")
    colors = page.script("return Array.from(document.querySelectorAll('#list .swatch'), item => item.style.background)")
    assert len(set(colors)) > 1, "segments of another method are colored by the kinds of surface"
    k, labels = page.count(), page.labels()
    for ending in (".ply", ".glb", ".obj", ".off"):
        page.script("document.getElementById('format').value = arguments[0]", ending)
        page.press("#save-mesh")
        page.idle()
        page.native("figure.off", "-o", "native" + ending, "-o", "part{segment}.ply")
        native = (page.folder / f"native{ending}").read_bytes().removeprefix(b"mtllib native.mtl\n") # a page writes one file
        assert page.downloaded(f"figure_{k}{ending}") == native, ending
    page.script("document.getElementById('format').value = '.ply'")
    page.browser.find_elements(By.CSS_SELECTOR, "#list li")[1].click()
    segment = page.script("return window.page.indexOf(window.page.selected)")
    page.browser.find_element(By.XPATH, "//button[text()='Save part']").click()
    page.idle()
    assert page.downloaded(f"figure_{k}_part_{segment}.ply") == (page.folder / f"part{segment}.ply").read_bytes()
    assert page.labels() == labels
    page.picture("part_saved")


def test(program, script, folder, pictures):
    status = subprocess.run(["sh", script, pictures]).returncode
    if status != 0:
        sys.exit(status)
    file = pictures / "segment_mesh.html"
    size = file.stat().st_size
    print(f"{size / 1e6:.2f} MB")
    assert size <= 3e6
    subprocess.run([program, "--demo", "-q", "-o", "figure.off"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    write_off(folder / "figure.off", *read_off(folder / "figure.off"))
    browser = start_browser(folder)
    try:
        page = LivePage(browser, file, program, folder, pictures)
        page.picture("empty")
        assert not page.browser.find_element(By.TAG_NAME, "aside").is_displayed()
        for check in (check_broken, check_formats, check_methods, check_strokes, check_keys, check_machine_part, check_saving, check_large):
            print(check.__name__, flush=True)
            check(page)
        check_looks(browser)
        errors = [entry for entry in browser.get_log("browser") if entry["level"] == "SEVERE"]
        assert not errors, json.dumps(errors)
    finally:
        browser.quit()


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        test(sys.argv[1], sys.argv[2], pathlib.Path(name), pathlib.Path(sys.argv[3]))
