#!/usr/bin/env python3
"""page_test.py PROGRAM PICTURE: a page of segment_mesh in headless Chromium, with 138,624 faces.

Moves the slider, splits, joins, undoes and saves as a user does; leaves a screenshot in PICTURE. Skipped without what browser.py
needs."""

import pathlib
import sys
import tempfile
import time

import numpy

from browser import ActionChains, By, Page, browser_for, write_large_mesh
from helpers import EXAMPLES, partition_of, rows_of, run
from selenium.webdriver.common.keys import Keys


def check_keys(page, browser):
    """What the mouse does, by the keyboard."""
    def focused():
        return page.script("return document.activeElement.dataset.node")

    def selected():
        items = browser.find_elements(By.CSS_SELECTOR, "#list li.selected")
        return [item.get_attribute("data-node") for item in items]

    def is_in_view():
        """Whether the list shows the selected item as far as it has room, in a window of any size."""
        return page.script(
            """const list = document.getElementById("list").getBoundingClientRect();
               const item = document.querySelector("#list li.selected").getBoundingClientRect();
               return item.height > list.height || (item.top > list.top - 1 && item.bottom < list.bottom + 1);""")

    def press(key, control, target="body"):
        """Whether it is left to the browser."""
        return page.script(
            "return document[arguments[2]].dispatchEvent(new KeyboardEvent('keydown', "
            "{key: arguments[0], ctrlKey: arguments[1], bubbles: true, cancelable: true}))", key, control, target)

    page.script("window.page.select(null)")
    page.script("document.querySelectorAll('#list li')[2].focus()")
    node = focused()
    for key, expected in ((Keys.ENTER, [node]), (Keys.ENTER, []), (Keys.SPACE, [node]), (Keys.SPACE, [])):
        browser.switch_to.active_element.send_keys(key)
        assert selected() == expected and focused() == node, (selected(), focused(), node)
        assert not expected or is_in_view(), "the selected segment is not shown"
    assert not press(" ", False, "activeElement") and selected() == [node], "the space bar is left to the browser, which scrolls"
    split = browser.find_element(By.CSS_SELECTOR, "#list li.selected .actions button")
    split.send_keys(Keys.ENTER)
    assert selected() == [focused()] and focused(), "the focus is lost"
    page.press("#undo")

    def tool():
        return page.script("return window.page.tool")

    for key, name in (("2", "split"), ("3", "join"), ("1", "select")):
        before = tool()
        assert press(key, True) and tool() == before, key
        assert not press(key, False) and tool() == name, key

    def eye():
        time.sleep(0.3)
        return page.script(
            """const {camera, controls} = window.page.view;
               return camera.position.clone().sub(controls.target).toArray();""")

    def distance(p, q=(0, 0, 0)):
        return sum((x - y) ** 2 for x, y in zip(p, q)) ** 0.5

    view, first = page.element("view"), eye()
    for there, back in ((Keys.ARROW_LEFT, Keys.ARROW_RIGHT), (Keys.ARROW_UP, Keys.ARROW_DOWN)):
        view.send_keys(there, there)
        turned = eye()
        assert distance(turned, first) > 0.1 * distance(first), turned
        assert abs(distance(turned) / distance(first) - 1) < 1e-6, turned
        view.send_keys(back, back)
        assert distance(eye(), first) < 1e-6 * distance(first), "not turned back"
    view.send_keys("+")
    assert abs(distance(eye()) / distance(first) - 0.9) < 1e-6
    view.send_keys("-")
    assert distance(eye(), first) < 1e-6 * distance(first)


def check_faces_of_no_segment(program, browser, folder):
    """They are no segment: not in the number, not in the name of a file, and not joined with one."""
    run(folder, program, "--demo", "-q", "-k", "6", "-o", "none.off", "-o", "none.seg")
    labels = [label if int(label) < 4 else "-1" for label in (folder / "none.seg").read_text().split()]
    (folder / "none.seg").write_text("\n".join(labels) + "\n")
    run(folder, program, "none.off", "--labels", "none.seg", "-q", "-o", "none.html")
    page = Page(browser, folder / "none.html", folder)
    assert page.count() == 4 and page.rows() == 5, page.count()
    assert page.labels() == labels
    places = page.places()
    assert 4 in places, "no face of no segment is seen"
    page.press("[data-tool=join]")
    page.click(places[0])
    page.click(places[4])
    assert page.labels() == labels and "no segment" in page.element("toast").text
    page.click(places[0])
    page.click(places[1])
    assert page.count() == 3
    page.press("#save-labels")
    assert page.saved("none_3.seg").split().count(b"-1") == labels.count("-1")


def check_names(program, browser, folder):
    """They are those of all outputs, also of segments whose numbers are not in the order of their first faces."""
    flange = EXAMPLES / "data/flange.off"
    for mesh, options in ((flange, ["--method", "smooth-faces"]), (folder / "none.off", ["--labels", "turned.seg"])):
        (folder / "turned.seg").write_text("".join(f"{3 - int(x)}\n" if 0 <= int(x) < 4 else "-1\n" for x in
                                                  (folder / "none.seg").read_text().split()))
        run(folder, program, mesh, *options, "-q", "-o", "names.html", "-o", "names.csv")
        page = Page(browser, folder / "names.html", folder)
        expected = {row["name"]: row["faces"] for row in rows_of(folder / "names.csv")}
        shown = page.script(
            """const {page} = window, faces = {};
               for (const item of document.querySelectorAll("#list li[data-node]"))
                 faces[item.querySelector("b").textContent] = page.measures[page.indexOf(Number(item.dataset.node))].faces;
               return faces;""")
        assert {name: str(faces) for name, faces in shown.items() if name != "No segment"} == expected, (shown, expected)
    page.press("[data-tool=join]")
    for segment in list(page.places())[:2]:
        page.click(page.places()[segment])
    names = [item.text for item in browser.find_elements(By.CSS_SELECTOR, "#list b")]
    assert sorted(names) == ["No segment", "segment_0", "segment_1", "segment_2"], names


def check_slider(page, program):
    """Labels are as the program gives them."""
    k = page.count()
    page.element("slider").send_keys(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ARROW_RIGHT)
    assert page.count() == k + 3 == page.rows(), page.count()
    run(page.folder, program, "a.off", "-q", "-k", str(k + 3), "-o", "b.seg")
    assert page.labels() == (page.folder / "b.seg").read_text().split(), "not the labels of the program"


def check_tree(page):
    """Splitting, joining and undoing by clicks."""
    before = partition_of(page.labels())
    page.press("[data-tool=split]")
    page.click(next(iter(page.places().values())))
    k = page.count()
    assert k == len(before) + 1, k
    after = partition_of(page.labels())
    assert len(before - after) == 1 and len(after - before) == 2
    assert frozenset().union(*(after - before)) == next(iter(before - after))
    page.press("[data-tool=join]")
    (a, place_of_a), (b, place_of_b) = list(page.places().items())[:2]
    labels = page.labels()
    joined = frozenset(i for i, x in enumerate(labels) if int(x) in (a, b))
    page.click(place_of_a)
    page.click(place_of_b)
    assert page.count() == k - 1 and joined in partition_of(page.labels())
    page.press("#undo")
    assert page.labels() == labels
    page.press("#undo")
    assert partition_of(page.labels()) == before
    page.press("#redo")
    assert page.labels() == labels
    ActionChains(page.browser).key_down(Keys.CONTROL).send_keys("z").perform()
    assert partition_of(page.labels()) == before
    ActionChains(page.browser).key_down(Keys.SHIFT).send_keys("z").key_up(Keys.SHIFT).perform()
    assert page.labels() == labels
    ActionChains(page.browser).send_keys("z").key_up(Keys.CONTROL).perform()


def check_selection(page):
    """Hovering names a segment, selecting describes it."""
    page.press("[data-tool=select]")
    segment, place = list(page.places().items())[-1]
    page.move_to(place).perform()
    tip = page.element("tip").text
    number, name, *_ = tip.split()
    assert name == f"segment_{segment}", tip
    row = page.browser.find_elements(By.CSS_SELECTOR, "#list li")[int(number) - 1]
    assert row.text.split()[:2] == [number, name], (row.text, tip)
    page.click(place)
    description = page.browser.find_element(By.CSS_SELECTOR, "#list li.selected dl").text
    assert "Area" in description and "Neighbors" in description, description

    # What is selected is hidden, shown alone, and shown with all others.
    seen = set(page.places())
    for key, expected in (("h", seen - {segment}), ("i", {segment}), ("a", seen)):
        page.element("view").send_keys(key, "f")
        time.sleep(0.3)
        assert set(page.places()) == expected, (key, set(page.places()), expected)


def count_orange(page):
    """Points of the picture in the color of the outline of what is selected."""
    return page.script(
        """window.page.view.draw(); const gl = window.page.view.renderer.getContext();
           const {drawingBufferWidth: width, drawingBufferHeight: height} = gl, bytes = new Uint8Array(4 * width * height);
           gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
           let count = 0;
           for (let i = 0; i < bytes.length; i += 4) count += bytes[i] > 250 && Math.abs(bytes[i + 1] - 128) < 4 && bytes[i + 2] < 4;
           return count;""")


def check_explosion(page, program):
    """Segments go apart and stay what they are, also in a file of those that are shown."""
    def explode(part):
        page.script("const slider = document.getElementById('explosion'); slider.value = arguments[0];"
                    "slider.dispatchEvent(new Event('input'))", part)

    def centers():
        return {segment: numpy.mean(places, axis=0) for segment, places in page.all_places().items()}

    page.script("window.page.select(null)")
    assert count_orange(page) == 0
    before = centers()
    explode(0.7)
    page.press("#fit")
    after = centers()
    common = list(before.keys() & after.keys())
    spread = [numpy.std([found[segment] for segment in common], axis=0).max() for found in (before, after)]
    segment, place = list(page.places().items())[-1]
    page.click(place)
    node = page.script("return window.page.selected")
    assert page.script("return window.page.indexOf(arguments[0])", node) == segment
    assert count_orange(page) > 50
    page.element("view").send_keys("h")
    page.press("#save-parts")
    page.saved(f"a_{page.count()}.glb")
    run(page.folder, program, f"a_{page.count()}.glb", "--labels-from", "groups", "-q", "-o", "parts.csv")
    expected = page.script(
        "const {page} = window; return page.nodes.filter(n => n !== page.selected).map(n => [page.nameOf(n), page.tree.areas[n]])")
    found = [(row["name"], float(row["area"])) for row in rows_of(page.folder / "parts.csv")]
    assert [name for name, _ in sorted(found)] == [name for name, _ in sorted(expected)], found
    numpy.testing.assert_allclose([area for _, area in sorted(found)], [area for _, area in sorted(expected)], rtol=1e-4)
    explode(0)
    page.element("view").send_keys("a", "f")
    assert spread[1] > spread[0], spread


def check_view(page, picture):
    """Turning changes the view."""
    view = page.element("view")
    region = page.script("return window.page.view.camera.position.toArray()")
    ActionChains(page.browser).move_to_element(view).click_and_hold().move_by_offset(60, 20).release().perform()
    time.sleep(0.5)
    assert page.script("return window.page.view.camera.position.toArray()") != region
    page.move_to(next(iter(page.places().values()))).perform()
    time.sleep(0.3)
    page.save_picture(picture)
    colors = page.script(
        """window.page.view.draw(); const gl = window.page.view.renderer.getContext(), n = 64, bytes = new Uint8Array(4);
           const colors = new Set();
           for (let i = 0; i < n * n; ++i) {
             gl.readPixels(i % n * gl.drawingBufferWidth / n, (i / n | 0) * gl.drawingBufferHeight / n, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
             colors.add(bytes.join());
           }
           return colors.size;""")
    assert colors > 50, f"{colors} colors"


def test(program, picture, folder):
    number_of_faces = write_large_mesh(folder / "a.off")
    run(folder, program, "a.off", "-q", "-k", "12", "-o", "a.html", "-o", "a.seg")
    with browser_for(folder) as browser:
        start = time.time()
        page = Page(browser, folder / "a.html", folder)
        print(f"{number_of_faces} faces: shown after {time.time() - start:.1f} s, "
              f"{(folder / 'a.html').stat().st_size / 1e6:.1f} MB")
        assert page.count() == page.rows() == 12
        assert page.labels() == (folder / "a.seg").read_text().split(), "not the labels of the program"
        check_slider(page, program)
        check_tree(page)
        check_selection(page)
        check_explosion(page, program)
        check_keys(page, browser)
        page.check_looks()
        check_view(page, picture)
        labels = page.labels()
        page.press("#save-labels")
        assert page.saved(f"a_{page.count()}.seg").decode().split() == labels
        check_faces_of_no_segment(program, browser, folder)
        check_names(program, browser, folder)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        test(sys.argv[1], sys.argv[2], pathlib.Path(name))
