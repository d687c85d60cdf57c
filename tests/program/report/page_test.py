"""Looks at a report page in headless Chromium: page_test.py CLEARWAY PROBLEM.cfg IN.path

Fails with a line that says what was expected. With CLEARWAY_FULL in the environment it also looks at two scenes of full
size."""

import base64
import os
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # the sources' folder stays as it is
import browser  # noqa: E402

kMostBytes = 20e6
kMostObjects = 6  # the picture of the environment, the part, the path, the closest pair's line and ends; one to spare


def require(holds, message):
    if not holds:
        sys.exit("page_test: " + message)


def nextFrames(page, count):
    """Waits until the page has been drawn so many times."""
    page.run(f"(async () => {{ for (let i = 0; i < {count}; ++i) await new Promise(requestAnimationFrame); }})()")


def pixels(page, area):
    """Returns the number of distinct colours in a part of the screen, and a sum that changes with any pixel."""
    png = base64.b64encode(page.screenshot()).decode()
    return page.run(f"""(async () => {{
        const image = new Image();
        image.src = 'data:image/png;base64,{png}';
        await image.decode();
        const canvas = document.createElement('canvas');
        canvas.width = {area["width"]}; canvas.height = {area["height"]};
        const context = canvas.getContext('2d');
        context.drawImage(image, -{area["x"]}, -{area["y"]});
        const words = new Uint32Array(context.getImageData(0, 0, canvas.width, canvas.height).data.buffer);
        let sum = 0;
        words.forEach((word, i) => {{ sum = (sum + word * (i % 1009 + 1)) % 4294967291; }});
        return {{colours: new Set(words).size, sum}};
    }})()""")


def areaOf(page, element):
    box = page.run(f"""(() => {{ const b = document.querySelector('{element}').getBoundingClientRect();
        return {{x: Math.round(b.x), y: Math.round(b.y), width: Math.round(b.width), height: Math.round(b.height)}}; }})()""")
    require(box["width"] > 100 and box["height"] > 50, f"{element} is {box}, expected room to see it")
    return box


def testLoading(page):
    require(page.run("document.querySelectorAll('#tables table').length") >= 3, "expected at least 3 tables")
    require(page.run("clearwayReport.frames.length") >= 100, "expected at least 100 places of the slider")
    for address in page.requests:
        require(address.startswith(("file:", "data:", "blob:")), f"the page asks for {address[:80]}")


def testSlider(page):
    """Moving the slider moves the part, the readout and the pictures, and moving it back undoes that."""
    view, profile = areaOf(page, "#view"), areaOf(page, "#profile")
    last = page.run("clearwayReport.frames.length - 1")

    def moveTo(i):
        page.run(f"""(() => {{ const slider = document.getElementById('slider');
            slider.value = {i}; slider.dispatchEvent(new Event('input')); }})()""")
        nextFrames(page, 3)
        return (page.run("clearwayReport.partPosition"), page.run("document.getElementById('readout').textContent"),
                pixels(page, view)["sum"], pixels(page, profile)["sum"])

    first = moveTo(0)
    require(pixels(page, view)["colours"] > 50, "expected a view with many colours")
    require(pixels(page, profile)["colours"] > 10, "expected a profile with a curve")
    frame = page.run("clearwayReport.frames[0].position")
    require(max(abs(a - b) for a, b in zip(first[0], frame)) < 1e-3, f"the part is at {first[0]}, expected {frame}")
    other = moveTo(last)
    for was, now, what in zip(first, other, ("part", "readout", "view", "profile")):
        require(was != now, f"the {what} did not change with the slider")
    require(moveTo(0) == first, "going back did not show the same again")


def testPlaying(page):
    """Clicks and looks within one script: on a busy machine the path could end between two of them."""
    seen = page.run("""(async () => {
        const report = clearwayReport, button = document.getElementById('play');
        button.click();
        const isStarted = report.isPlaying;
        while (report.isPlaying && report.frame === 0) await new Promise(requestAnimationFrame);
        const hasMoved = report.frame > 0;
        button.click();
        return {isStarted, hasMoved, isStopped: !report.isPlaying};
    })()""")
    require(seen["isStarted"], "expected the play button to start it")
    require(seen["hasMoved"], "expected the part to move while it plays")
    require(seen["isStopped"], "expected the play button to stop it")


def testProfileAndButtons(page):
    box = areaOf(page, "#profile")
    for kind in ("mousePressed", "mouseReleased"):
        page.ask("Input.dispatchMouseEvent", type=kind, button="left", clickCount=1,
                 x=box["x"] + box["width"] // 2, y=box["y"] + box["height"] // 2)
    share = page.run("clearwayReport.frames[clearwayReport.frame].share")
    require(0.4 < share < 0.55, f"a click in the middle of the profile went to {share}")
    page.run("document.getElementById('tightest').click()")
    least = page.run("Math.min(...clearwayReport.frames.map((f) => f.clearance ?? Infinity))")
    require(page.run("clearwayReport.frames[clearwayReport.frame].clearance") == least, "expected the tightest place")
    page.run("document.querySelector('tr.jump:last-child').click()")
    view = areaOf(page, "#view")
    before = pixels(page, view)["sum"]
    page.run("""(() => { const axis = document.getElementById('cut-axis');
        axis.value = 'y'; axis.dispatchEvent(new Event('input')); })()""")
    nextFrames(page, 3)
    cut = pixels(page, view)["sum"]
    require(cut != before, "the cut did not change the view")
    page.run("document.getElementById('closer').click()")
    nextFrames(page, 3)
    require(pixels(page, view)["sum"] != cut, "looking closer did not change the view")


def testRedraws(page):
    """A redraw is quick because it draws the part alone: the environment is a picture that was drawn before."""
    count = page.run("clearwayReport.frames.length")
    sizes = page.run("clearwayReport.trianglesOf")
    most = sizes["part"] + 2  # the picture is a rectangle
    nextFrames(page, 3)
    for i in range(16):
        drawn = page.run(f"clearwayReport.drawnFor({i * count // 16}, false)")
        require(sizes["part"] <= drawn["triangles"] <= most,
                f"a redraw draws {drawn['triangles']} triangles, expected those of the part, {sizes['part']}, and the picture's 2")
        require(drawn["objects"] <= kMostObjects, f"a redraw draws {drawn['objects']} objects, expected at most {kMostObjects}")
    drawn = page.run("clearwayReport.drawnFor(0, true)")["triangles"]
    require(drawn >= sizes["part"] + sizes["environment"], f"a redraw of all draws {drawn} triangles, expected the environment's too")


def testPage(program, problem, path, folder):
    file = os.path.join(folder, "report.html")
    subprocess.run([program, "check", problem, path, "--report", file], check=True, stdout=subprocess.DEVNULL)
    size = os.path.getsize(file)
    print(f"page: {size / 1e6:.1f} MB")
    require(size <= kMostBytes, f"the page has {size} bytes, expected at most {kMostBytes:.0f}")
    page = browser.Page(file)
    try:
        testLoading(page)
        testSlider(page)
        testPlaying(page)
        testProfileAndButtons(page)
        testRedraws(page)
        require(not page.errors, f"the console shows {page.errors}")
    finally:
        page.close()


def main():
    program, problem, path = sys.argv[1:4]
    require(browser.find_chromium(), "no chromium, expected the package that cmake/packages_tests.txt names")
    with tempfile.TemporaryDirectory() as folder:
        testPage(program, problem, path, folder)
        if not os.environ.get("CLEARWAY_FULL"):
            return
        for name, part, environment in (("tunnel-console", 73425, 300401), ("large-environment", 120000, 1700000)):
            scene = os.path.join(folder, name)
            subprocess.run([program, "scene", name, "--out", scene, "--part-triangles", str(part),
                            "--environment-triangles", str(environment)], check=True, stdout=subprocess.DEVNULL)
            stem = os.path.join(scene, name)
            testPage(program, stem + ".cfg", stem + ".path", folder)


main()
