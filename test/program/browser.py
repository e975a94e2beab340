"""What the tests of pages share: headless Chromium, a page of the program in it, and a mesh of 138,624 faces. Needs Debian's
chromium, chromium-driver and python3-selenium; without them the test is skipped."""

import contextlib
import json
import shutil
import time

import numpy

from helpers import EXAMPLES, need, read_off, skip, write_off

try:
    from selenium import webdriver
    from selenium.common.exceptions import TimeoutException
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
except ImportError:
    skip("no python3-selenium")


@contextlib.contextmanager
def browser_for(downloads):
    """In the end there must be no errors in its log."""
    need("chromium", "chromedriver")
    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium")
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--window-size=1280,800",
                     "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--host-resolver-rules=MAP * ~NOTFOUND"):
        options.add_argument(argument)
    options.add_experimental_option("prefs", {"download.default_directory": str(downloads)})
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    browser = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
    try:
        browser.set_script_timeout(300)
        yield browser
        errors = [entry for entry in browser.get_log("browser") if entry["level"] == "SEVERE"]
        assert not errors, json.dumps(errors)
    finally:
        browser.quit()


class Page:
    def __init__(self, browser, file, folder):
        self.browser, self.folder, self.script = browser, folder, browser.execute_script
        browser.get(file.as_uri())
        self.wait("!!window.page || !document.getElementById('failure').hidden")
        failure = self.element("failure").text
        assert not failure, failure

    def wait(self, condition, seconds=120):
        end = time.time() + seconds
        while not self.script("return " + condition):
            assert time.time() < end, f"not in {seconds} s: {condition}"
            time.sleep(0.005)

    def element(self, name):
        return self.browser.find_element(By.ID, name)

    def count(self):
        return int(self.element("count").get_attribute("value"))

    def rows(self):
        return len(self.browser.find_elements(By.CSS_SELECTOR, "#list li[data-node]"))

    def labels(self):
        return self.script("return window.page.labels()").split()

    def press(self, name):
        self.browser.find_element(By.CSS_SELECTOR, name).click()

    def all_places(self):
        """For each segment that is seen, places of the canvas where the page itself says that it is."""
        found = self.script(
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

    def saved(self, name):
        """The bytes of a file that the page saves."""
        file = self.folder / name
        for _ in range(100):
            if file.exists():
                return file.read_bytes()
            time.sleep(0.1)
        raise AssertionError(f"{name} is not saved: {sorted(f.name for f in self.folder.iterdir())}")

    def save_picture(self, file):
        """A screenshot. Its driver waits 10 s for one, which is drawn without a graphics card: too short on a busy machine."""
        for _ in range(5):
            with contextlib.suppress(TimeoutException):
                self.browser.save_screenshot(str(file))
                return
        raise AssertionError("no screenshot")

    def check_looks(self):
        """Texts have a contrast of at least 4.5 : 1, and a group of choices holds choices alone."""
        found = self.script(
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
        for group in self.browser.find_elements(By.CSS_SELECTOR, "[role=radiogroup]"):
            children = group.find_elements(By.CSS_SELECTOR, "*")
            assert {child.get_attribute("role") for child in children} == {"radio"}


def subdivided(points, faces):
    """Each triangle divided in four."""
    edges = numpy.sort(faces[:, [[0, 1], [1, 2], [2, 0]]], axis=2).reshape(-1, 2)
    edges, index = numpy.unique(edges, axis=0, return_inverse=True)
    (a, b, c), (ab, bc, ca) = faces.T, len(points) + index.reshape(-1, 3).T
    corners = (a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)
    return numpy.concatenate([points, points[edges].mean(axis=1)]), numpy.concatenate([numpy.transpose(t) for t in corners])


def write_large_mesh(file):
    """Two figures side by side. The number of its faces."""
    points, faces, _ = read_off(EXAMPLES / "data/figure.off")
    points, faces = subdivided(*subdivided(numpy.array(points), numpy.array(faces)))
    write_off(file, numpy.concatenate([points, points + (3, 0, 0)]), numpy.concatenate([faces, faces + len(points)]))
    return 2 * len(faces)
