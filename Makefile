# Installs hug as a C library, for those who have no cargo-c (with it:
# cargo cinstall --release). Needs cargo, GNU make and binutils.
#
#     make                          builds both libraries below target/install
#     make install PREFIX=/usr      the default is /usr/local; DESTDIR for packagers
#     make uninstall PREFIX=/usr    removes exactly what install puts there
#
# Variables, with their defaults below: PREFIX, LIBDIR, INCLUDEDIR, DATADIR, DESTDIR;
# TARGET_DIR is cargo's; CARGO, LD, AR, NM, OBJCOPY, INSTALL name programs.

PREFIX ?= /usr/local
LIBDIR ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include
DATADIR ?= $(PREFIX)/share
PKGCONFIGDIR ?= $(LIBDIR)/pkgconfig
CMAKEDIR := $(DATADIR)/hug/cmake

CARGO ?= cargo
OBJCOPY ?= objcopy
NM ?= nm
INSTALL ?= install

HERE := $(patsubst %/,%,$(dir $(abspath $(lastword $(MAKEFILE_LIST)))))
TARGET_DIR ?= $(HERE)/target/install
OUT := $(TARGET_DIR)/release
STAGE := $(TARGET_DIR)/stage

VERSION := $(shell sed -n 's/^version = "\(.*\)"/\1/p' $(HERE)/Cargo.toml | head -n 1)
MAJOR := $(word 1,$(subst ., ,$(VERSION)))
MINOR := $(word 2,$(subst ., ,$(VERSION)))
# Before 1.0 every minor version may break programs, so it is part of the soname.
SOVERSION := $(MAJOR)$(if $(filter 0,$(MAJOR)),.$(MINOR))
SONAME := libhug.so.$(SOVERSION)
SHARED := libhug.so.$(VERSION)

HEADERS := hug.h hug.hpp hug_builder.hpp hug_queries.hpp hug_embree.h hug_embree_packets.h
CMAKE_FILES := hug-config.cmake hug-config-version.cmake

.PHONY: all build install uninstall
.DELETE_ON_ERROR:

all: build

# One call builds both; what the static one needs of the system is rustc's to say. The
# archive is joined to one object in which hug_* alone is visible: other Rust libraries
# of the program bring functions of the same names as ours does. (The compiler that links
# adds libc, and libgcc_s or, with -static, libgcc_eh by itself.)
build: | $(STAGE)
	cd $(HERE) && $(CARGO) rustc --release --lib --features capi --crate-type staticlib,cdylib \
		--target-dir $(TARGET_DIR) -- -C link-arg=-Wl,-soname,$(SONAME) \
		--print native-static-libs=$(STAGE)/native-static-libs
	cp $(OUT)/libhug.so $(STAGE)/$(SHARED)
	$(OBJCOPY) --strip-unneeded $(STAGE)/$(SHARED)
	$(LD) -r --gc-sections -o $(STAGE)/hug.o $(OUT)/libhug.a \
		$$($(NM) -g --defined-only $(OUT)/libhug.a 2>/dev/null | sed -n 's/.* T \(hug_.*\)/-u \1/p')
	$(OBJCOPY) -w --strip-debug -R .llvmbc -R .llvmcmd --keep-global-symbol='hug_*' $(STAGE)/hug.o
	rm -f $(STAGE)/libhug.a
	$(AR) rcs $(STAGE)/libhug.a $(STAGE)/hug.o
	$(file >$(STAGE)/hug.pc,$(PC))
	printf 'Libs.private: %s\n' "$$(sed 's/-lgcc_s *//; s/ *-lc$$//' $(STAGE)/native-static-libs)" \
		>>$(STAGE)/hug.pc

$(STAGE):
	mkdir -p $@

define PC
prefix=$(PREFIX)
libdir=$(patsubst $(PREFIX)/%,$${prefix}/%,$(LIBDIR))
includedir=$(patsubst $(PREFIX)/%,$${prefix}/%,$(INCLUDEDIR))

Name: hug
Description: Exact, watertight ray intersection
Version: $(VERSION)
Cflags: -I$${includedir}
Libs: -L$${libdir} -lhug
endef

install: build
	$(INSTALL) -d $(DESTDIR)$(LIBDIR) $(DESTDIR)$(INCLUDEDIR) $(DESTDIR)$(PKGCONFIGDIR) \
		$(DESTDIR)$(CMAKEDIR)
	$(INSTALL) -m 644 $(HEADERS:%=$(HERE)/include/%) $(DESTDIR)$(INCLUDEDIR)
	$(INSTALL) -m 644 $(STAGE)/libhug.a $(DESTDIR)$(LIBDIR)
	$(INSTALL) -m 755 $(STAGE)/$(SHARED) $(DESTDIR)$(LIBDIR)
	ln -sf $(SHARED) $(DESTDIR)$(LIBDIR)/$(SONAME)
	ln -sf $(SHARED) $(DESTDIR)$(LIBDIR)/libhug.so
	$(INSTALL) -m 644 $(STAGE)/hug.pc $(DESTDIR)$(PKGCONFIGDIR)
	$(INSTALL) -m 644 $(CMAKE_FILES:%=$(HERE)/cmake/%) $(DESTDIR)$(CMAKEDIR)

uninstall:
	rm -f $(HEADERS:%=$(DESTDIR)$(INCLUDEDIR)/%) $(CMAKE_FILES:%=$(DESTDIR)$(CMAKEDIR)/%) \
		$(addprefix $(DESTDIR)$(LIBDIR)/,libhug.a libhug.so $(SONAME) $(SHARED)) \
		$(DESTDIR)$(PKGCONFIGDIR)/hug.pc
	rmdir $(DESTDIR)$(CMAKEDIR) $(DESTDIR)$(DATADIR)/hug 2>/dev/null || true
