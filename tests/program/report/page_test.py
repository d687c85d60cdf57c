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
    before = viewSum(page)
    page.run("""(() => { const axis = document.getElementById('cut-axis');
        axis.value = 'y'; axis.dispatchEvent(new Event('input')); })()""")
    cut = viewSum(page)
    require(cut != before, "the cut did not change the view")
    page.run("document.getElementById('closer').click()")
    require(viewSum(page) != cut, "looking closer did not change the view")


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


def writeBoxes(file, boxes):
    """boxes: name, low corner, high corner."""
    with open(file, "w") as out:
        for n, (name, low, high) in enumerate(boxes):
            print("o", name, file=out)
            for i in range(8):
                print("v", *((high if i >> axis & 1 else low)[axis] for axis in range(3)), file=out)
            for a, b, c, d in ((1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)):
                print("f", *(8 * n + i for i in (a, b, c, d)), file=out)


def writePeg(folder):
    """Writes a problem: a peg goes through the slot of a plate, then sideways into a post. 200 studs stand around."""
    writeBoxes(os.path.join(folder, "peg.obj"), [("peg", (-5, -5, -20), (5, 5, 20))])
    writeBoxes(os.path.join(folder, "plate.obj"), [
        ("left", (-100, -100, -5), (-7, 100, 5)), ("right", (7, -100, -5), (100, 100, 5)),
        ("front", (-7, -100, -5), (7, -8, 5)), ("back", (-7, 8, -5), (7, 100, 5)), ("post", (40, -5, -90), (50, 5, -5)),
        *((f"stud{i}", (-95 + 9.5 * (i % 20), 60 + 4 * (i // 20), 5), (-93 + 9.5 * (i % 20), 62 + 4 * (i // 20), 9)) for i in range(200))])
    ends = "".join(f"{end}.{key} = {value}\n" for end, place in (("start", (0, 0, 60)), ("goal", (60, 0, -50)))
                   for key, value in [*zip("xyz", place), ("axis.x", 0), ("axis.y", 0), ("axis.z", 1), ("theta", 0)])
    with open(os.path.join(folder, "peg.cfg"), "w") as out:
        out.write(f"[problem]\nrobot = peg.obj\nworld = plate.obj\n{ends}[clearway]\nreading = stored\n")
    with open(os.path.join(folder, "peg.path"), "w") as out:
        out.write("0 0 60 0 0 0 1\n0 0 60 0 0 0.866025 0.5\n0 0 60 0 0 0.866025 -0.5\n0 0 60 0 0 0 -1\n")  # one turn
        out.write("0 0 -50 0 0 0 1\n60 0 -50 0 0 0 1\n")
    return os.path.join(folder, "peg.cfg"), os.path.join(folder, "peg.path")


def waitUntil(page, condition):
    """Waits until the expression holds, at most 10 seconds."""
    holds = page.run(f"""(async () => {{ for (const end = performance.now() + 10000; performance.now() < end;) {{
        if ({condition}) return true;
        await new Promise((done) => setTimeout(done, 10));
    }} return false; }})()""")
    require(holds, f"waited in vain until {condition}")


# Sums of all pixels of the view and of the profile, which change with any pixel. Quicker than a picture of the screen.
kSums = """(words) => { let sum = 0; words.forEach((word, i) => { sum = (sum + word * (i % 1009 + 1)) % 4294967291; }); return sum; }"""


def viewSum(page):
    return page.run(f"""(() => {{
        const view = clearwayReport.view, gl = view.renderer.getContext();
        const words = new Uint32Array(gl.drawingBufferWidth * gl.drawingBufferHeight);
        view.redraw();
        gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(words.buffer));
        return ({kSums})(words);
    }})()""")


def profileSum(page):
    return page.run(f"""(() => {{
        const canvas = document.getElementById('profile');
        const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        return ({kSums})(new Uint32Array(pixels.data.buffer));
    }})()""")


def testFirstView(page):
    """The first view shows the part at its start, at its goal and between."""
    width, height = (areaOf(page, "#view")[side] for side in ("width", "height"))
    count = page.run("clearwayReport.frames.length")
    for i in (0, count // 2, count - 1):
        x, y = page.run(f"clearwayReport.placeInView(clearwayReport.frames[{i}].position)")
        require(0 < x < width and 0 < y < height, f"the first view shows frame {i} at {x}, {y}, expected within {width} x {height}")
    require(page.run("clearwayReport.data.view.visible") > 0.5, "expected a first view that the plate hides little of")


def testSwitches(page):
    """Each switch changes the view, and switching back undoes that."""
    before = viewSum(page)
    for switch in ("ghosts", "edges"):
        page.run(f"document.getElementById('{switch}').click()")
        require(viewSum(page) != before, f"the switch {switch} did not change the view")
        page.run(f"document.getElementById('{switch}').click()")
        require(viewSum(page) == before, f"switching {switch} back did not show the same again")
    page.run("""(() => { const slider = document.getElementById('opacity');
        slider.value = slider.value < 50 ? 90 : 30; slider.dispatchEvent(new Event('input')); })()""")
    require(viewSum(page) != before, "the slider of the surroundings did not change the view")


def testObstacles(page):
    """The list names the nearest obstacles, the worst first, counts the others, and hides each."""
    names = page.run("[...document.querySelectorAll('#obstacles label')].map((label) => label.textContent.trim())")
    require(names[0] == "post", f"the worst obstacle is {names[0]}, expected the post that the part runs into")
    require(set(names[1:5]) == {"left", "right", "front", "back"}, f"next come {names[1:5]}, expected the four sides of the slot")
    require(names[-1].startswith("125 other obstacles"), f"the last row is {names[-1]}, expected that it counts the others")
    bounds = page.run("[...document.querySelectorAll('#obstacles td.number')].map((cell) => cell.textContent)")
    trouble = page.run("clearwayReport.data.environment.objects.find((object) => object.name === 'post').trouble")
    require(trouble and bounds[0] == trouble and bounds[1] == "2", f"the clearances begin with {bounds[:2]}, expected '{trouble}' and 2")
    before = viewSum(page)
    page.run("document.querySelectorAll('#obstacles input')[1].click()")
    require(viewSum(page) != before, "hiding an obstacle did not change the view")
    page.run("document.getElementById('all-obstacles').click()")
    require(viewSum(page) == before, "showing all obstacles did not show the same again")


def testHover(page):
    page.run("document.getElementById('whole').click()")
    view = areaOf(page, "#view")
    x, y = page.run("clearwayReport.placeInView([-60, -60, clearwayReport.data.environment.low[2] + clearwayReport.data.environment.extent[2] - 4])")
    page.ask("Input.dispatchMouseEvent", type="mouseMoved", x=view["x"] + x, y=view["y"] + y)
    waitUntil(page, "!document.getElementById('hover').hidden")
    name = page.run("document.getElementById('hover').textContent")
    require(name.startswith("left"), f"under the pointer is '{name}', expected the plate's left side")
    page.press("h", "h")
    require(page.run("clearwayReport.data.environment.objects.findIndex((o, i) => clearwayReport.view.wall.body.runs[i].isHidden)") == 0,
            "expected the key h to hide what is under the pointer")
    page.press("a", "a")


def testTurning(page):
    """A turn is shown at every few degrees, in two seconds, and the degrees are told."""
    last = page.run("clearwayReport.frames[clearwayReport.frames.length - 1]")
    require(359 < last["turned"] < 361, f"the part turns by {last['turned']} degrees, expected 360")
    most = page.run("Math.max(...clearwayReport.frames.slice(1).map((frame, i) => frame.turned - clearwayReport.frames[i].turned))")
    require(most < 6.5, f"the part turns by {most} degrees from one place to the next, expected at most 6")
    time = page.run("clearwayReport.frames.find((frame) => frame.turned > 359).time")
    require(time > 1.9, f"the turn takes {time} s, expected 2")
    page.run("clearwayReport.choose(clearwayReport.frames.findIndex((frame) => frame.turned > 179))")
    readout = page.run("document.getElementById('readout').textContent")
    require("\u00b0 of 360\u00b0" in readout, f"the readout is '{readout}', expected the degrees turned")
    page.run("clearwayReport.choose(0)")


def testSection(page):
    """Where the closest pair's gap is hidden, the tightest place is cut open: part, gap and obstacle differ in colour."""
    require(page.run("clearwayReport.data.view.isTightHidden"), "expected a gap that is hidden")
    for button, axis in (("tightest", "gap"), ("way", "")):
        page.run(f"document.getElementById('{button}').click()")
        shown = page.run("document.getElementById('cut-axis').value")
        require(shown == axis, f"the button {button} cuts '{shown}', expected '{axis}'")
    page.run("document.getElementById('tightest').click()")
    colours = page.run("""(() => {
        const report = clearwayReport, gl = report.view.renderer.getContext(), frame = report.frames[report.frame];
        const [part, wall] = frame.pair.map((point) => report.placeInView(point)), gap = [wall[0] - part[0], wall[1] - part[1]];
        const colourAt = (share, beside) => {  // beside: the line between the pair, in gaps
            const x = part[0] + share * gap[0] - beside * gap[1], y = part[1] + share * gap[1] + beside * gap[0], pixel = new Uint8Array(4);
            gl.readPixels(Math.round(x), Math.round(report.view.container.clientHeight - y), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
            return pixel.slice(0, 3).join(' ');
        };
        report.view.redraw();
        return [-2, 2].map((beside) => [-2, 0.5, 3].map((share) => colourAt(share, beside)));
    })()""")
    require(any(len(set(three)) == 3 for three in colours), f"part, gap and obstacle have the colours {colours}, expected three")


def writeTray(folder):
    """Writes a problem: a battery in a closed tray, 0.2 from its walls, with a lid above."""
    writeBoxes(os.path.join(folder, "battery.obj"), [("battery", (0, 0, 0), (30, 60, 10))])
    writeBoxes(os.path.join(folder, "tray.obj"), [
        ("a_tray_with_a_name_that_is_long", (-5, -5, -5), (35, 65, -0.1)), ("left", (-5, -5, -0.1), (-0.2, 65, 12)),
        ("right", (30.2, -5, -0.1), (35, 65, 12)), ("front", (-0.2, -5, -0.1), (30.2, -0.2, 12)),
        ("back", (-0.2, 60.2, -0.1), (30.2, 65, 12)), ("lid", (-5, -5, 12), (35, 65, 14))])
    with open(os.path.join(folder, "tray.cfg"), "w") as out:
        out.write("[problem]\nrobot = battery.obj\nworld = tray.obj\n" + "".join(
            f"start.{key} = {value}\n" for key, value in zip(("x", "y", "z", "axis.x", "axis.y", "axis.z", "theta"), (0, 0, 0, 0, 0, 1, 0))) +
            "[clearway]\nreading = stored\ngoal = outside\nunit = mm\ncontact.start = *tray*, 0.5\n")
    with open(os.path.join(folder, "tray.path"), "w") as out:
        out.write("0 0 0 0 0 0 1\n0 0 1 0 0 0 1\n")
    return os.path.join(folder, "tray.cfg"), os.path.join(folder, "tray.path")


def testWidths(page, width):
    """Nothing reaches beyond the page's or the panels' borders."""
    beyond = page.run("""[document.documentElement, ...document.querySelectorAll('body *')]
        .filter((e) => e.clientWidth && e.scrollWidth > e.clientWidth + 1).map((e) => `${e.tagName} ${e.id} ${e.className}`)""")
    require(not beyond, f"{beyond} are wider than their places in a page of {width}")
    right = page.run("Math.max(...[...document.querySelectorAll('body *')].map((e) => e.getBoundingClientRect().right))")
    require(right <= width, f"something reaches to {right} in a page of {width}")


def testTray(program, folder):
    file = os.path.join(folder, "tray.html")
    subprocess.run([program, "check", *writeTray(folder), "--report", file], stdout=subprocess.DEVNULL)
    page = browser.Page(file)
    try:
        testWidths(page, 1280)
        testSection(page)
        page.ask("Emulation.setDeviceMetricsOverride", width=390, height=844, deviceScaleFactor=1, mobile=True)
        nextFrames(page, 3)
        testWidths(page, 390)
        page.press("?", "?")
        testWidths(page, 390)
        require(not page.errors, f"the console shows {page.errors}")
    finally:
        page.close()


def testKeyboard(page):
    frame = lambda: page.run("clearwayReport.frame")  # noqa: E731
    last = page.run("clearwayReport.frames.length - 1")
    for key, expected in (("End", last), ("ArrowLeft", last - 1), ("Home", 0), ("ArrowRight", 1)):
        page.press(key)
        require(frame() == expected, f"{key} goes to frame {frame()}, expected {expected}")
    page.press(" ", " ")
    require(page.run("clearwayReport.isPlaying"), "expected the space bar to play")
    page.press(" ", " ")
    require(not page.run("clearwayReport.isPlaying"), "expected the space bar to pause")
    page.press("?", "?")
    require(page.run("document.getElementById('help').open"), "expected ? to show the keys")
    page.press("Escape")
    page.run("document.getElementById('help').close()")


def testContact(page):
    """Where the part is in contact it has the colour of contact, hatched in black."""
    page.run("clearwayReport.choose(clearwayReport.frames.findIndex((frame) => frame.trouble))")
    require(page.run("clearwayReport.view.hatching.value") > 0, "expected hatching on the part in contact")
    require(page.run("document.getElementById('readout').textContent.startsWith(clearwayReport.frames[clearwayReport.frame].trouble)"),
            "expected the readout to say what is wrong")
    page.run("clearwayReport.choose(0)")
    require(page.run("clearwayReport.view.hatching.value") == 0, "expected no hatching where the part is free")


def testTightest(page):
    """The flight to the tightest place ends with the closest pair in the middle of the view, and the panel names the pair."""
    page.emulate(("prefers-reduced-motion", "no-preference"))
    # Pressed within the page, because on a slow machine the flight can end before the next question comes.
    pressed = "document.dispatchEvent(new KeyboardEvent('keydown', { key: 't' })), clearwayReport.isFlying"
    require(page.run(pressed), "expected a flight to the tightest place")
    waitUntil(page, "!clearwayReport.isFlying")
    view = areaOf(page, "#view")
    x, y = page.run("clearwayReport.placeInView(clearwayReport.frames[clearwayReport.data.tightest].pair[1])")
    require(abs(x - view["width"] / 2) < 40 and abs(y - view["height"] / 2) < 40, f"the closest pair is at {x}, {y}, expected the middle")
    require(page.run("clearwayReport.frame === clearwayReport.data.tightest"), "expected the tightest frame")
    panel = page.run("document.getElementById('closest-rows').textContent + document.getElementById('closest-note').textContent")
    for words in ("peg", "post", "counted from 0", "x y z w", "w is last"):
        require(words in panel, f"the panel shows '{panel}', expected '{words}'")
    text = page.run("clearwayReport.closestText(clearwayReport.frames[0])")
    require("translation: 0 0 60" in text and "quaternion x y z w: 0 0 0 1" in text, f"the text to copy is '{text}', expected the pose of the start")


def testProfileModes(page):
    """The logarithmic profile and the look change what is drawn; the picture is that of the view."""
    linear, light = profileSum(page), viewSum(page)
    middle = """(() => { const { range: [low, high], plot, isLogarithmic } = clearwayReport.profile, profile = clearwayReport.profile;
        return profile.y(isLogarithmic ? Math.sqrt(low * high) : (low + high) / 2) - (plot.top + plot.bottom) / 2; })()"""
    for isLogarithmic in (True, False):
        page.press("l", "l")
        require(page.run("clearwayReport.profile.isLogarithmic") == isLogarithmic, "expected the key l to switch the profile")
        require(abs(page.run(middle)) < 1e-6, "expected the mean of the profile's range in its middle")
        if isLogarithmic:
            require(profileSum(page) != linear, "the logarithmic profile looks like the linear one")
    page.press("d", "d")
    paper = page.run("getComputedStyle(document.body).backgroundColor")
    require(paper != "rgb(255, 255, 255)", f"the dark look has the paper {paper}")
    require(profileSum(page) != linear, "the dark look did not change the profile")
    require(viewSum(page) != light, "the dark look did not change the view")
    size = page.run("""(() => { const canvas = clearwayReport.picture();
        const words = new Uint32Array(canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.buffer);
        return [canvas.width, new Set(words).size]; })()""")
    require(size[0] == areaOf(page, "#view")["width"] and size[1] > 50, f"the picture has width and colours {size}")


def testFits(page):
    """Nothing is cut off at the page's borders, and no two controls overlap."""
    boxes = page.run("""[...document.querySelectorAll('button, select, input, #readout, #scale, h1')]
        .filter((e) => e.offsetWidth && !e.closest('aside') && !e.closest('dialog') && e.id !== 'slider').map((e) => {
            const b = e.getBoundingClientRect(); return [e.id || e.textContent, b.left, b.top, b.right, b.bottom]; })""")
    for i, (name, left, top, right, bottom) in enumerate(boxes):
        require(left >= 0 and top >= 0 and right <= 1280 and bottom <= 720, f"{name} is at {left}, {top}, {right}, {bottom}, expected it within the page")
        for other in boxes[:i]:
            apart = other[3] <= left or right <= other[1] or other[4] <= top or bottom <= other[2]
            require(apart, f"{name} overlaps {other[0]}")


def testWithoutWebGl(file):
    page = browser.Page(file, flags=["--disable-3d-apis"], look="dark")
    try:
        require(page.run("getComputedStyle(document.getElementById('failure')).display") != "none", "expected words in place of the view")
        require(page.run("document.documentElement.dataset.look") == "dark", "expected the look that the browser prefers")
        areaOf(page, "#profile")
        page.press("t", "t")
        require(page.run("clearwayReport.frame === clearwayReport.data.tightest"), "expected the tightest frame without a view")
        require(page.run("document.querySelectorAll('#obstacles tr').length") == 81, "expected the list of obstacles without a view")
        testFits(page)
        require(not page.errors, f"without WebGL the console shows {page.errors}")
    finally:
        page.close()


def testPeg(program, folder):
    file = os.path.join(folder, "peg.html")
    subprocess.run([program, "check", *writePeg(folder), "--report", file], stdout=subprocess.DEVNULL)  # the path collides
    page = browser.Page(file, 960, 600)  # fewer pixels take less time
    try:
        for test in (testFirstView, testTurning, testSwitches, testObstacles, testHover, testKeyboard, testContact, testTightest,
                     testProfileModes):
            test(page)
        require(not page.errors, f"the console shows {page.errors}")
    finally:
        page.close()
    testWithoutWebGl(file)


def testPage(program, problem, path, folder):
    file = os.path.join(folder, "report.html")
    subprocess.run([program, "check", problem, path, "--report", file], check=True, stdout=subprocess.DEVNULL)
    size = os.path.getsize(file)
    print(f"page: {size / 1e6:.1f} MB")
    require(size <= kMostBytes, f"the page has {size} bytes, expected at most {kMostBytes:.0f}")
    page = browser.Page(file)
    try:
        testLoading(page)
        testFits(page)
        testSlider(page)
        testPlaying(page)
        testProfileAndButtons(page)
        testRedraws(page)
        require(not page.errors, f"the console shows {page.errors}")
    finally:
        page.close()


def main():
    program, problem, path = sys.argv[1:4]
    with tempfile.TemporaryDirectory() as folder:
        testPeg(program, folder)
        testTray(program, folder)
        testPage(program, problem, path, folder)
        if not os.environ.get("CLEARWAY_FULL"):
            return
        for name, part, environment in (("tunnel-console", 73425, 300401), ("large-environment", 120000, 1700000)):
            scene = os.path.join(folder, name)
            subprocess.run([program + "-scene", name, "--out", scene, "--part-triangles", str(part),
                            "--environment-triangles", str(environment)], check=True, stdout=subprocess.DEVNULL)
            stem = os.path.join(scene, name)
            testPage(program, stem + ".cfg", stem + ".path", folder)


main()
