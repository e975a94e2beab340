#!/usr/bin/env python3
"""page_test.py PROGRAM PICTURE: a page of segment_mesh in headless Chromium, with 200,000 faces.

Moves the slider, splits, joins, undoes and saves as a user does; leaves a screenshot in PICTURE. Needs Debian's chromium,
chromium-driver and python3-selenium; without them it is skipped."""

import csv
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

SKIPPED = 77

try:
    from selenium import webdriver
    from selenium.common.exceptions import TimeoutException
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
except ImportError:
    print("skipped: no python3-selenium")
    sys.exit(SKIPPED)


def read_off(file):
    numbers = file.read_text().split()[1:]
    n, m = int(numbers[0]), int(numbers[1])
    values = numbers[3:]
    points = [tuple(map(float, values[3 * i:3 * i + 3])) for i in range(n)]
    start = 3 * n
    length = (len(values) - start) // m  # of a triangle, with or without a color
    faces = [tuple(map(int, values[start + length * f + 1:start + length * f + 4])) for f in range(m)]
    return points, faces


def write_off(file, points, faces):
    lines = [f"OFF\n{len(points)} {len(faces)} 0"] + [f"{x!r} {y!r} {z!r}" for x, y, z in points]
    file.write_text("\n".join(lines + [f"3 {a} {b} {c}" for a, b, c in faces]) + "\n")


def subdivided(points, faces):
    """Each triangle divided in four."""
    points, middles, result = list(points), {}, []

    def middle(i, j):
        key = (min(i, j), max(i, j))
        if key not in middles:
            middles[key] = len(points)
            points.append(tuple((x + y) / 2 for x, y in zip(points[i], points[j])))
        return middles[key]

    for a, b, c in faces:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        result += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return points, result


def beside_itself(points, faces):
    """Twice, side by side along x."""
    n = len(points)
    return (points + [(x + 3, y, z) for x, y, z in points], faces + [tuple(i + n for i in face) for face in faces])


def start_browser(downloads):
    driver, browser = shutil.which("chromedriver"), shutil.which("chromium")
    if not driver or not browser:
        print("skipped: no chromium with chromedriver")
        sys.exit(SKIPPED)
    options = webdriver.ChromeOptions()
    options.binary_location = browser
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--window-size=1280,800",
                     "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--host-resolver-rules=MAP * ~NOTFOUND"):
        options.add_argument(argument)
    options.add_experimental_option("prefs", {"download.default_directory": str(downloads)})
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    browser = webdriver.Chrome(service=Service(driver), options=options)
    browser.set_script_timeout(300)
    return browser


class Page:
    def __init__(self, browser, file):
        self.browser = browser
        browser.get(file.as_uri())
        for _ in range(600):
            if browser.execute_script("return !!window.page || !document.getElementById('failure').hidden"):
                break
            time.sleep(0.1)
        failure = self.element("failure").text
        assert not failure, failure

    def element(self, name):
        return self.browser.find_element(By.ID, name)

    def count(self):
        return int(self.element("count").get_attribute("value"))

    def rows(self):
        return len(self.browser.find_elements(By.CSS_SELECTOR, "#list li[data-node]"))

    def labels(self):
        return self.browser.execute_script("return window.page.labels()").split()

    def press(self, name):
        self.browser.find_element(By.CSS_SELECTOR, name).click()

    def all_places(self):
        """For each segment that is seen, places of the canvas where the page itself says that it is."""
        found = self.browser.execute_script(
            """const page = window.page, {view} = page, {width, height} = view.ids, bytes = new Uint8Array(4 * width * height);
               view.draw();
               view.renderer.readRenderTargetPixels(view.ids, 0, 0, width, height, bytes);
               const found = {}, ratio = view.renderer.getPixelRatio();
               for (let row = 8; row < height; row += 16)
                 for (let column = 8; column < width; column += 16) {
                   const at = 4 * (row * width + column), region = bytes[at] + 256 * bytes[at + 1] - 1;
                   if (region < 0) continue;
                   const segment = page.segmentOfRegion[region];
                   (found[segment] = found[segment] || []).push([column / ratio, (height - 1 - row) / ratio].map(Math.round));
                 }
               return found;""")
        return {int(segment): places for segment, places in found.items()}

    def places(self):
        """For each segment that is seen, one of them."""
        return {segment: places[len(places) // 2] for segment, places in self.all_places().items()}

    def move_to(self, place):
        view = self.element("view")
        return ActionChains(self.browser).move_to_element_with_offset(
            view, place[0] - view.size["width"] // 2, place[1] - view.size["height"] // 2)

    def click(self, place):
        self.move_to(place).click().perform()


def partition_of(labels):
    return {frozenset(i for i, x in enumerate(labels) if x == label) for label in set(labels)}


def make_mesh(program, folder):
    """Two of the figures of the program, side by side, with 222,080 faces."""
    subprocess.run([program, "--demo", "-q", "-o", "a.off"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    points, faces = beside_itself(*subdivided(*subdivided(*read_off(folder / "a.off"))))
    write_off(folder / "a.off", points, faces)
    return len(faces)


def check_keys(page, browser):
    """What the mouse does, by the keyboard."""
    def focused():
        return browser.execute_script("return document.activeElement.dataset.node")

    def selected():
        items = browser.find_elements(By.CSS_SELECTOR, "#list li.selected")
        return [item.get_attribute("data-node") for item in items]

    def is_in_view():
        """Whether the list shows the selected item as far as it has room, in a window of any size."""
        return browser.execute_script(
            """const list = document.getElementById("list").getBoundingClientRect();
               const item = document.querySelector("#list li.selected").getBoundingClientRect();
               return item.height > list.height || (item.top > list.top - 1 && item.bottom < list.bottom + 1);""")

    def press(key, control, target="body"):
        """Whether it is left to the browser."""
        return browser.execute_script(
            "return document[arguments[2]].dispatchEvent(new KeyboardEvent('keydown', "
            "{key: arguments[0], ctrlKey: arguments[1], bubbles: true, cancelable: true}))", key, control, target)

    browser.execute_script("window.page.select(null)")
    browser.execute_script("document.querySelectorAll('#list li')[2].focus()")
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
        return browser.execute_script("return window.page.tool")

    for key, name in (("2", "split"), ("3", "join"), ("1", "select")):
        before = tool()
        assert press(key, True) and tool() == before, key
        assert not press(key, False) and tool() == name, key

    def eye():
        time.sleep(0.3)
        return browser.execute_script(
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


def check_looks(browser):
    """Texts have a contrast of at least 4.5 : 1, and a group of choices holds choices alone."""
    found = browser.execute_script(
        r"""const luminance = color => {
             const linear = v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
             const [r, g, b] = color.map(v => linear(v / 255));
             return 0.2126 * r + 0.7152 * g + 0.0722 * b;
           };
           const numbers = text => text.match(/[\d.]+/g).map(Number);
           const groundOf = item => { // the darkest color of a gradient
             for (; item; item = item.parentElement) {
               const style = getComputedStyle(item), color = numbers(style.backgroundColor);
               if (style.backgroundImage !== "none")
                 return style.backgroundImage.match(/rgb\([^)]*\)/g).map(numbers)
                   .sort((a, b) => luminance(a) - luminance(b))[0];
               if (color.length === 3 || color[3] === 1) return color;
             }
           };
           const contrasts = [];
           for (const item of document.querySelectorAll("#help, aside *")) {
             const texts = Array.from(item.childNodes).filter(node => node.nodeType === 3);
             if (item.disabled || !texts.some(text => text.data.trim())) continue;
             const [dark, bright] = [numbers(getComputedStyle(item).color), groundOf(item)]
               .map(color => luminance(color.slice(0, 3))).sort((a, b) => a - b);
             contrasts.push([(bright + 0.05) / (dark + 0.05), item.textContent]);
           }
           return contrasts.sort((a, b) => a[0] - b[0]);""")
    assert len(found) > 20 and found[0][0] >= 4.5, found[:3]
    for group in browser.find_elements(By.CSS_SELECTOR, "[role=radiogroup]"):
        children = group.find_elements(By.CSS_SELECTOR, "*")
        assert {child.get_attribute("role") for child in children} == {"radio"}


def save_picture(browser, picture):
    """A screenshot. Its driver waits 10 s for one, which is drawn without a graphics card: too short on a busy machine."""
    for _ in range(5):
        try:
            browser.save_screenshot(picture)
            return
        except TimeoutException:
            pass
    raise AssertionError("no screenshot")


def saved_labels(file):
    """Of a file that the page saves."""
    for _ in range(100):
        if file.exists():
            break
        time.sleep(0.1)
    return file.read_text().split()


def check_faces_of_no_segment(program, browser, folder):
    """They are no segment: not in the number, not in the name of a file, and not joined with one."""
    subprocess.run([program, "--demo", "-q", "-k", "6", "-o", "none.off", "-o", "none.seg"], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    labels = [label if int(label) < 4 else "-1" for label in (folder / "none.seg").read_text().split()]
    (folder / "none.seg").write_text("\n".join(labels) + "\n")
    subprocess.run([program, "none.off", "--labels", "none.seg", "-q", "-o", "none.html"], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    page = Page(browser, folder / "none.html")
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
    assert saved_labels(folder / "none_3.seg").count("-1") == labels.count("-1")


def check_names(program, browser, folder):
    """They are those of all outputs, also of segments whose numbers are not in the order of their first faces."""
    flange = pathlib.Path(__file__).parents[2] / "examples" / "data" / "flange.off"
    for mesh, options in ((flange, ["--method", "smooth-faces"]), (folder / "none.off", ["--labels", "turned.seg"])):
        (folder / "turned.seg").write_text("".join(f"{3 - int(x)}\n" if 0 <= int(x) < 4 else "-1\n" for x in
                                                  (folder / "none.seg").read_text().split()))
        subprocess.run([program, mesh, *options, "-q", "-o", "names.html", "-o", "names.csv"], cwd=folder, check=True)
        page = Page(browser, folder / "names.html")
        with open(folder / "names.csv", newline="") as table:
            expected = {row["name"]: row["faces"] for row in csv.DictReader(table)}
        shown = browser.execute_script(
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


def test(program, picture, folder):
    number_of_faces = make_mesh(program, folder)
    k = 12
    subprocess.run([program, "a.off", "-q", "-k", str(k), "-o", "a.html", "-o", "a.seg"], cwd=folder, check=True)
    browser = start_browser(folder)
    try:
        start = time.time()
        page = Page(browser, folder / "a.html")
        print(f"{number_of_faces} faces: shown after {time.time() - start:.1f} s, "
              f"{(folder / 'a.html').stat().st_size / 1e6:.1f} MB")
        assert page.count() == k and page.rows() == k
        assert page.labels() == (folder / "a.seg").read_text().split(), "not the labels of the program"

        # The slider: labels as the program gives them.
        slider = page.element("slider")
        slider.send_keys(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ARROW_RIGHT)
        assert page.count() == k + 3 == page.rows(), page.count()
        subprocess.run([program, "a.off", "-q", "-k", str(k + 3), "-o", "b.seg"], cwd=folder, check=True,
                       stdout=subprocess.DEVNULL)
        assert page.labels() == (folder / "b.seg").read_text().split(), "not the labels of the program"

        # Splitting, joining and undoing by clicks.
        before = partition_of(page.labels())
        page.press("[data-tool=split]")
        page.click(next(iter(page.places().values())))
        assert page.count() == k + 4, page.count()
        after = partition_of(page.labels())
        assert len(before - after) == 1 and len(after - before) == 2
        assert frozenset().union(*(after - before)) == next(iter(before - after))
        page.press("[data-tool=join]")
        (a, place_of_a), (b, place_of_b) = list(page.places().items())[:2]
        labels = page.labels()
        joined = frozenset(i for i, x in enumerate(labels) if int(x) in (a, b))
        page.click(place_of_a)
        page.click(place_of_b)
        assert page.count() == k + 3 and joined in partition_of(page.labels())
        page.press("#undo")
        assert page.labels() == labels
        page.press("#undo")
        assert partition_of(page.labels()) == before
        page.press("#redo")
        assert page.labels() == labels
        page.press("#undo")

        # Hovering names a segment, selecting describes it.
        page.press("[data-tool=select]")
        segment, place = list(page.places().items())[-1]
        page.move_to(place).perform()
        tip = page.element("tip").text
        assert tip.split()[0] == f"segment_{segment}", tip
        page.click(place)
        description = browser.find_element(By.CSS_SELECTOR, "#list li.selected dl").text
        assert "Area" in description and "Neighbors" in description, description

        # What is selected is hidden, shown alone, and shown with all others.
        seen = set(page.places())
        for key, expected in (("h", seen - {segment}), ("i", {segment}), ("a", seen)):
            page.element("view").send_keys(key, "f")
            time.sleep(0.3)
            assert set(page.places()) == expected, (key, set(page.places()), expected)

        check_keys(page, browser)
        check_looks(browser)

        # Turning changes the view.
        view = page.element("view")
        region = page.browser.execute_script("return window.page.view.camera.position.toArray()")
        ActionChains(browser).move_to_element(view).click_and_hold().move_by_offset(60, 20).release().perform()
        time.sleep(0.5)
        assert page.browser.execute_script("return window.page.view.camera.position.toArray()") != region
        page.move_to(next(iter(page.places().values()))).perform()
        time.sleep(0.3)
        save_picture(browser, picture)
        colors = browser.execute_script(
            """window.page.view.draw(); const gl = window.page.view.renderer.getContext(), n = 64, bytes = new Uint8Array(4);
               const colors = new Set();
               for (let i = 0; i < n * n; ++i) {
                 gl.readPixels(i % n * gl.drawingBufferWidth / n, (i / n | 0) * gl.drawingBufferHeight / n, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
                 colors.add(bytes.join());
               }
               return colors.size;""")
        assert colors > 50, f"{colors} colors"

        page.press("#save-labels")
        assert partition_of(saved_labels(folder / f"a_{k + 3}.seg")) == before
        check_faces_of_no_segment(program, browser, folder)
        check_names(program, browser, folder)
        errors = [entry for entry in browser.get_log("browser") if entry["level"] == "SEVERE"]
        assert not errors, json.dumps(errors)
    finally:
        browser.quit()


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        test(sys.argv[1], sys.argv[2], pathlib.Path(name))
