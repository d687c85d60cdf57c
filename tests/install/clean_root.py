"""A clean Debian root, which debootstrap makes from this machine's own package mirror."""

import os
import re
import shutil
import subprocess
import sys
import urllib.request

# Mounts and processes of these commands end with them.
ON_THEIR_OWN = ["unshare", "--mount", "--pid", "--fork", "--kill-child"]


def own_release():
    """The codename of this machine's Debian; None on others."""
    found = re.search(r"^VERSION_CODENAME=(\w+)", open("/etc/os-release").read(), re.M)
    return found and found.group(1)


def mirror():
    """The address of this machine's first mirror that holds its own release of Debian; None when there is none."""
    form = ["--format", "$(SITE) $(CODENAME) $(ORIGIN)", "Created-By: Packages"]
    rows = subprocess.run(["apt-get", "indextargets"] + form, stdout=subprocess.PIPE, text=True, check=True).stdout
    for row in rows.splitlines():
        address, codename, origin = (row.split(" ") + ["", ""])[:3]
        if codename == own_release() and origin == "Debian":
            return address
    return None


class CleanRoot:
    """A root in a folder, which is there within a `with`. Without root rights, mounts of its own or the mirror it says what is skipped, and
    ends the program with 0."""

    def __init__(self, folder, codename, purpose):
        self.folder, self.codename, self.purpose = folder, codename, purpose

    def skip(self, reason):
        print("skipped: %s, because %s" % (self.purpose, reason))
        sys.exit(0)

    def __enter__(self):
        if os.geteuid() != 0:
            self.skip("debootstrap needs root")
        if subprocess.run(ON_THEIR_OWN + ["true"], stderr=subprocess.DEVNULL).returncode:
            self.skip("this root cannot make mounts of its own")
        address = mirror()
        if not address:
            self.skip("no package source of this machine has Debian's release %s" % own_release())
        try:
            urllib.request.urlopen("%s/dists/%s/Release" % (address, self.codename), timeout=30).close()
        except OSError as reason:
            self.skip("%s cannot be reached (%s)" % (address, reason))
        print("Making a root of %s" % self.codename, flush=True)
        shutil.rmtree(self.folder, ignore_errors=True)
        made = subprocess.run(ON_THEIR_OWN + ["debootstrap", "--variant=minbase", self.codename, self.folder, address],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if made.returncode != 0:
            shutil.rmtree(self.folder, ignore_errors=True)
            sys.exit("debootstrap ended with %d:\n%s" % (made.returncode, made.stdout))
        return self

    def __exit__(self, *error):
        shutil.rmtree(self.folder, ignore_errors=True)

    def command(self, script):
        """What runs a script of bash in the root. Nothing of the caller's environment is there; lscpu, which OMPL 1.6 calls, needs /sys."""
        return ON_THEIR_OWN + ["--mount-proc=" + self.folder + "/proc", "chroot", self.folder, "env", "-i", "HOME=/root", "LC_ALL=C.UTF-8",
                               "DEBIAN_FRONTEND=noninteractive", "PATH=/usr/sbin:/usr/bin:/sbin:/bin", "bash", "-c", "mount -t sysfs sysfs /sys; " + script]
