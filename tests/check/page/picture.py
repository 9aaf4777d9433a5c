"""Takes the README's picture of the page: picture.py BUILD CHROMIUM OUT.png"""
import os
import sys
import tempfile

from chromium import Chromium

BUILD, PROGRAM, OUT = sys.argv[1:4]
with tempfile.TemporaryDirectory() as profile:
    browser = Chromium(PROGRAM, profile)
    try:
        browser.size(1120, 640)
        browser.theme('light')
        browser.open('file://' + os.path.abspath(BUILD + '/page/index.html') + '#lattice')
        browser.wait("document.body?.dataset.gjk === 'ok'")
        browser.run("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
        browser.picture(OUT)
    finally:
        browser.close()
